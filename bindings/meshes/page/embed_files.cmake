# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# cmake -DFILES=A;B;... -DOUTPUT=SOURCE -P embed_files.cmake
# Writes the function page_source(), which returns the bytes of each file, by its name.

set(files "")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME)
  file(READ ${file} bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
  string(REPLACE "\\x0a" "\\x0a\"\n     \"" bytes "${bytes}")
  string(APPEND files "    {\"${name}\",\n     \"${bytes}\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by embed_files.cmake
#include <map>
#include <string>

namespace segment_mesh {

const std::string& page_source(const std::string& name);

const std::string& page_source(const std::string& name)
{
  static const std::map<std::string, std::string> sources = {
${files}  };
  return sources.at(name);
}

} // namespace segment_mesh
")
