#!/usr/bin/env bash
# Runs the commands of README.md, CONTRIBUTING.md and docs/: every ```sh block after a line `<!--
# checked -->` must succeed with the freshly built asos in the PATH. Each document has its own empty
# folder. Links and names with a trailing slash must exist, and pictures of docs/images must be used
# somewhere.
# Usage: readme_test.sh SOURCE_DIR ASOS
set -euo pipefail
cd -- "$1"
root=$PWD
program=$2

work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
mkdir "$work/bin"
# Documents ask for pictures that people look at. Here a quarter of the width and height will do, but
# where a command names places in the picture.
cat >"$work/bin/asos" <<END
#!/usr/bin/env bash
arguments=("\$@")
if [[ \${1-} == render && " \$* " != *' --crop '* ]]; then
  for ((i = 1; i < \$#; ++i)); do
    [[ \${arguments[i]} == --size && \${arguments[i + 1]} =~ ^([0-9]+)x([0-9]+)\$ ]] || continue
    arguments[i + 1]=\$((BASH_REMATCH[1] / 4))x\$((BASH_REMATCH[2] / 4))
  done
fi
exec $(printf '%q' "$program") "\${arguments[@]}"
END
chmod +x "$work/bin/asos"

# checked_blocks DOCUMENT PREFIX: writes one file per block, PREFIX1 and so on.
checked_blocks() {
  awk -v prefix="$2" '
    /^<!-- checked -->$/ { wanted = 1; next }
    /^```sh$/ && wanted { inside = 1; wanted = 0; ++n; next }
    /^```$/ { inside = 0; next }
    inside { print > (prefix n) }
    !inside && NF { wanted = 0 }
  ' "$1"
}

# anchors DOCUMENT: the anchors of its headings, as used in links.
anchors() {
  grep -E '^#+ ' "$1" | sed -E 's/^#+ //' | tr '[:upper:] ' '[:lower:]-' | tr -cd 'a-z0-9_\n-'
}

mapfile -t documents < <(printf '%s\n' README.md CONTRIBUTING.md; find docs -name '*.md' | sort)
count=0
for document in "${documents[@]}"; do
  here="$work/${document//\//+}"
  mkdir "$here"
  checked_blocks "$document" "$work/block-"
  for block in "$work"/block-*; do
    [[ -f $block ]] || break
    count=$((count + 1))
    echo "-- $document:"
    cat -- "$block"
    (cd -- "$here" && env -u DISPLAY -u WAYLAND_DISPLAY PATH="$work/bin:$PATH" bash -eu "$block")
    rm -- "$block"
  done
done
# Detects a document with commands that lost its marks, and a search that finds no documents.
((count >= 12)) || {
  echo "$count checked blocks were found; at least 12 are expected"
  exit 1
}

status=0
for document in "${documents[@]}"; do
  while IFS= read -r name; do
    [[ $name != http* ]] || continue
    file=${name%%#*}
    target=$root/$(dirname -- "$document")/$file
    [[ -n $file ]] || target=$root/$document
    if [[ ! -e $target ]]; then
      echo "$document links to $name, which does not exist"
      status=1
    elif [[ $name == *#* ]] && ! anchors "$target" | grep -qxF -- "${name#*#}"; then
      echo "$document links to $name, but $file has no such heading"
      status=1
    fi
  done < <(grep -oE '\]\([^)]+\)' "$document" | sed -E 's/^\]\(|\)$//g')
  while IFS= read -r name; do
    [[ -e $name ]] || {
      echo "$document names $name, which does not exist"
      status=1
    }
  done < <(grep -oE '`[a-z_/]+/`' "$document" | tr -d '`')
done
for picture in docs/images/*.png; do
  grep -qF -- "images/$(basename -- "$picture")" "${documents[@]}" || {
    echo "$picture is shown nowhere"
    status=1
  }
done
((status == 0)) && echo "$count blocks ran"
exit $status
