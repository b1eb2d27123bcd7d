#!/usr/bin/env bash
# The numbers in the manual's table of limits are those of the code, at the places named here.
# Usage: limits_test.sh SOURCE_DIR
set -euo pipefail
export LC_ALL=C
cd -- "$1"
status=0
fail() {
  status=1
  printf '%s\n' "$*"
}
page=docs/manual/limits.md
table=$(grep '^| [a-z.J]' "$page" | grep -v '^| limit |')
declare -A told

# limit ROW NUMBER FILE CODE: the row's second column has the number, and the file the code.
limit() {
  local row
  told[$1]=1
  row=$(grep -F -- "| $1 |" <<<"$table") || {
    fail "$page: its table of limits has no row '$1'"
    return
  }
  [[ $row == "| $1 |"*"$2"*"|"*"|" ]] || fail "$page: '$1' should say $2: $row"
  grep -qF -- "$4" "$3" || fail "$3: no longer says '$4', which $page states as '$1'"
}

gltf=renderer/gltf
limit 'files' 'regular ones only' renderer/files/read_file.cpp '!S_ISREG'
limit '.glb' '8 GiB' $gltf/container.cpp 'most_file_bytes = std::uint64_t{8} << 30;'
limit '.gltf, and the JSON of a .glb' '1 GiB' $gltf/container.cpp \
  'most_json_bytes = std::uint64_t{1} << 30;'
limit 'external buffer or texture' '8 GiB' $gltf/files.cpp \
  'largest_outside_file = std::uint64_t{8} << 30;'
limit '.hdr' '300 MiB' renderer/film/hdr_io.cpp 'most_bytes = std::uint64_t{300} << 20;'
limit '.exr' '8 GiB' renderer/film/exr_io.cpp 'most_exr_bytes = std::uint64_t{8} << 30;'
limit 'saved pictures (`--from`)' '4 GiB' renderer/film/image_text.cpp \
  'largest_picture = std::uint64_t{4} << 30;'
limit 'text in a picture' '16 MB' renderer/film/image_text.h 'most_image_text = std::size_t{16} << 20;'
pictures=renderer/gltf/pictures
limit 'textures' '16384 pixels a side' $pictures/picture.h 'largest_picture_side = 16384;'
limit 'textures' '1100 for each byte' $pictures/picture.cpp 'most_pixels_per_byte = 1100;'
limit 'all textures' '2^24' $gltf/texture_budget.cpp 'free_texels = std::uint64_t{1} << 24;'
limit 'all textures' '8 for each' $gltf/texture_budget.cpp 'texels_per_byte = 8;'
held='decoder memory of interlaced PNGs, progressive JPEGs, lossless WebPs, TGAs and BMPs'
limit "$held" '128 MiB' $pictures/picture.cpp 'free_held_bytes = std::uint64_t{128} << 20'
limit "$held" '16 for each byte' $pictures/picture.cpp 'held_bytes_per_byte = 16;'
limit "$held" '200 scans' $pictures/jpeg_picture.cpp 'most_scans = 200;'
limit 'JSON objects' '200 MB' $gltf/tidy.cpp 'free_memory = std::uint64_t{200} << 20'
limit 'JSON objects' '40 bytes' $gltf/tidy.cpp 'memory_per_byte = 40;'
limit 'skies' '2^25' renderer/film/hdr_io.cpp 'free_pixels = std::size_t{1} << 25;'
limit 'skies' '2^26 pixels' renderer/shading/sky_file.cpp 'most_texels = std::int64_t{1} << 26;'
limit 'skies' '.exr: 2^27' renderer/shading/sky_file.cpp \
  'most_exr_texels = std::int64_t{1} << 27;'
kept='stored pixels of an .exr sky'
limit "$kept" '2^24' renderer/shading/sky_file.cpp 'free_exr_texels = std::int64_t{1} << 24;'
limit "$kept" 'one for 5 bytes' renderer/shading/sky_file.cpp 'bytes_a_texel = 5;'
limit 'sky radiance' '1e15' renderer/shading/sky_file.cpp 'most_radiance = 1e15f;'
limit 'outline pieces of alpha masks' '2 million' renderer/features/cut_outs.h \
  'lines = std::size_t{1} << 21;'
limit 'triangles' '60 million' renderer/gltf/load.h "max_triangles = 60'000'000;"
limit 'triangles' '220 bytes' $gltf/memory_check.cpp 'bytes_a_triangle = 220'
limit 'objects' '300 bytes' $gltf/memory_check.cpp 'bytes_an_object = 300;'
limit 'objects' '4 million' $gltf/importer.cpp "most_instances = 4'000'000;"
limit 'extent of a scene' '1e15' renderer/geometry/coordinates.h 'largest_coordinate = 1e15;'
limit 'distance of cameras and lights' '1e15' renderer/geometry/coordinates.h \
  'largest_coordinate = 1e15;'
limit 'warnings' '100' $gltf/warnings.cpp 'most_warnings = 100;'
limit 'warnings' '500 bytes' $gltf/warnings.cpp 'longest_remark = 500;'
limit 'warnings' 'printed 10' app/render_warnings.cpp 'most_lines = 10;'
limit 'steps of motion blur' '1024' renderer/prepared/exposure.h 'most_steps = 1024;'
limit 'steps of motion blur' '4 million' renderer/prepared/exposure.h "most_triangles = 4'000'000,"
limit 'steps of motion blur' '16 million' renderer/prepared/exposure.h "most_ray_triangles = 16'000'000;"
limit 'picture side' '32768 pixels' renderer/settings/setting_table.cpp 'max_side = 32768;'

# A row may have several numbers.
rows=$(wc -l <<<"$table")
((rows == ${#told[@]})) || fail "$page: $rows rows of limits, of which ${#told[@]} are compared"
if ((status == 0)); then echo "$rows limits are those of the code"; fi
exit $status
