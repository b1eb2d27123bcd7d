#!/usr/bin/env bash
# Packs the build as two Debian packages, unpacks the program's in another place and runs it there:
# lists the scenes, renders one, and checks that the desktop's files are in their places. The package
# depends on the libraries that the program is linked with. The other package holds the library's
# files and no program.
# Usage: install_test.sh BUILD_DIR
set -euo pipefail
build=$1
for tool in cpack dpkg-deb dpkg-shlibdeps; do
  command -v "$tool" >/dev/null || {
    echo "skipped: $tool is not installed"
    exit 77
  }
done
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
fail() {
  echo "$*"
  exit 1
}

cd -- "$work"
cpack --config "$build/CPackConfig.cmake" -B "$work/out" >pack.log 2>&1 || fail "$(cat pack.log)"
package=$(echo out/asos_*.deb)
[[ -s $package ]] || fail "no package: $(cat pack.log)"
depends=$(dpkg-deb --field "$package" Depends)
for library in libc6 libstdc++6 libembree libglfw3 libopenexr libpng16 libgl1; do
  [[ $depends == *$library* ]] || fail "the package does not depend on $library: $depends"
done

development=$(echo out/libasos-dev_*.deb)
[[ -s $development ]] || fail "no package of the library: $(cat pack.log)"
dpkg-deb --contents "$development" >development.list
for file in include/asos/asos.h libasos. cmake/asos/asosConfig.cmake pkgconfig/asos.pc \
  doc/libasos-dev/copyright; do
  grep -qF -- "$file" development.list || fail "$development lacks $file"
done
! grep -q '/bin/' development.list || fail "$development contains the program"
! dpkg-deb --contents "$package" | grep -qE '/(include|cmake)/' || fail "$package contains headers"
[[ $(dpkg-deb --field "$development" Depends) == *libembree-dev* || ! $(cat development.list) == *libasos.a* ]] ||
  fail "$development does not depend on the packages of the static library"

dpkg-deb --extract "$package" root
run() { env -i HOME="$work" PATH=/usr/bin:/bin LANG=C.UTF-8 "$work/root/usr/bin/asos" "$@"; }
scenes=$(run list-scenes)
[[ $scenes == *office* ]] || fail "it lists no scenes: $scenes"
run render builtin:boxes -o picture.png --size 64x36 --quiet
run render --from picture.png -o again.png --quiet
cmp <(convert picture.png rgb:-) <(convert again.png rgb:-) || fail 'the pictures differ'
[[ $(run --version) == asos* ]] || fail 'no version'

notices=root/usr/share/doc/asos/copyright
for words in 'Copyright (c) 2026 The ASOS authors' '==== libimgui-dev ====' 'Omar Cornut' \
  '==== libtinygltf-dev ====' 'Syoyo Fujita' '==== libembree-dev ====' '==== zlib1g-dev ===='; do
  grep -qF -- "$words" "$notices" || fail "the package's licences do not say '$words'"
done

desktop=root/usr/share/applications/asos.desktop
grep -qx 'Exec=asos view %f' "$desktop" || fail 'the desktop entry starts something else'
grep -qx 'MimeType=model/gltf-binary;model/gltf+json;' "$desktop" || fail 'it opens no glTF'
icon=root/usr/share/icons/hicolor/scalable/apps/$(sed -n 's/^Icon=//p' "$desktop").svg
[[ -s $icon ]] || fail "no icon $icon"
if command -v desktop-file-validate >/dev/null; then desktop-file-validate "$desktop"; fi
if command -v xmllint >/dev/null; then xmllint --noout "$icon"; fi
echo "installed and run: $(basename -- "$package")"
