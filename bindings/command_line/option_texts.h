// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_OPTION_TEXTS_H
#define SEGMENT_MESH_OPTION_TEXTS_H

#include <CGAL/Spectral_segmentation/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace segment_mesh {

// All that have a group, as those without one are not shown.
inline std::vector<const CLI::Option*> documented_options(const CLI::App& app)
{
  return app.get_options([](const CLI::Option* option) { return !option->get_group().empty(); });
}

// -o, --labels ...
inline std::vector<std::string> names_of(const CLI::Option& option)
{
  std::vector<std::string> result;
  for (const std::string& name : option.get_snames())
    result.push_back('-' + name);
  for (const std::string& name : option.get_lnames())
    result.push_back("--" + name);
  return result;
}

// The words that an option takes, which CLI11 writes as TYPE:{first,second}.
inline std::vector<std::string> choices_of(const CLI::Option& option)
{
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find(":{"), end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos)
    return {};
  return CLI::detail::split(type.substr(begin + 2, end - begin - 2), ',');
}

// For man(1), in its language.
inline std::string man_page(const CLI::App& app)
{
  const auto escaped = [](std::string text) {
    std::string result;
    for (char c : text)
      result += c == '\\' ? std::string("\\e") : c == '-' ? std::string("\\-") : std::string(1, c);
    return result;
  };
  std::string options;
  for (const CLI::Option* option : documented_options(app)) {
    std::string heading;
    for (const std::string& name : names_of(*option))
      heading += (heading.empty() ? "\\fB" : ", \\fB") + escaped(name) + "\\fR";
    const std::string type = option->get_type_name();
    if (option->get_positional())
      heading = "\\fI" + escaped(option->get_name(true)) + "\\fR";
    else if (option->get_items_expected_max() > 0)
      heading += " \\fI" + escaped(type.substr(0, type.find(':'))) + "\\fR";
    std::string text = escaped(option->get_description());
    for (const std::string& choice : choices_of(*option))
      text += (choice == choices_of(*option).front() ? "; one of " : ", ") + escaped(choice);
    options += ".TP\n" + heading + "\n" + text + "\n";
  }
  return ".TH SEGMENT_MESH 1 \"\" \"segment_mesh " CGAL_SPECTRAL_SEGMENTATION_VERSION "\"\n"
         ".SH NAME\nsegment_mesh \\- cuts a mesh into the parts that a person would name\n"
         ".SH SYNOPSIS\n.B segment_mesh\n\\fIIN\\fR ... [\\fIoptions\\fR]\n"
         ".SH OPTIONS\n" + options +
         ".SH EXIT STATUS\n" + escaped(app.get_footer()) + "\n";
}

// For bash: names of options, their choices, and else names of files.
inline std::string bash_completion(const CLI::App& app)
{
  std::string names, cases;
  for (const CLI::Option* option : documented_options(app)) {
    const std::vector<std::string> choices = choices_of(*option);
    if (!choices.empty())
      cases += "    " + CLI::detail::join(names_of(*option), "|") +
               ") COMPREPLY=($(compgen -W \"" + CLI::detail::join(choices, " ") +
               "\" -- \"$word\")); return ;;\n";
    for (const std::string& name : names_of(*option))
      names += (names.empty() ? "" : " ") + name;
  }
  return "# Completion of segment_mesh for bash\n"
         "_segment_mesh() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]}\n"
         "  case ${COMP_WORDS[COMP_CWORD-1]} in\n" + cases +
         "  esac\n"
         "  [[ $word == -* ]] && COMPREPLY=($(compgen -W \"" + names + "\" -- \"$word\"))\n"
         "}\n"
         "complete -o bashdefault -o default -F _segment_mesh segment_mesh\n";
}

// How many characters must be changed, inserted or left out (Levenshtein 1966).
inline std::size_t edit_distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1); // to the first characters of b
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = i;
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = (std::min)({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

// The name of an option that may have been meant; empty if none is like it.
inline std::string similar_option(const CLI::App& app, std::string word)
{
  word = word.substr(0, word.find('='));
  std::string result;
  std::size_t smallest = word.size() / 3 + 1; // a third of the characters may be wrong
  for (const CLI::Option* option : documented_options(app))
    for (const std::string& name : names_of(*option)) {
      const bool is_beginning = word.size() > 2 && name.compare(0, word.size(), word) == 0;
      const std::size_t distance = is_beginning ? 0 : edit_distance(word, name);
      if (distance < smallest) {
        smallest = distance;
        result = name;
      }
    }
  return result;
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_OPTION_TEXTS_H
