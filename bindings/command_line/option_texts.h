// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_OPTION_TEXTS_H
#define SEGMENT_MESH_OPTION_TEXTS_H

#include "../meshes/Failure.h"

#include <CGAL/Spectral_segmentation/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace segment_mesh {

struct Example
{
  const char *command, *effect;
};

const Example examples[] = {
  {"segment_mesh bear.off --html bear.html", "shows the parts in a browser."},
  {"segment_mesh bear.off -o bear.glb -o bear.ply --segments 6", "writes exactly six parts."},
  {"segment_mesh bear.off -o bear.ply && scripts/render.py bear.ply",
   "draws bear.png, by a script of the source."},
  {"segment_mesh bear.stl --split-dir parts --split-format 3mf --close --unit mm",
   "writes closed parts for 3D printing."},
  {"segment_mesh scan.obj --split-dir parts --split-format glb",
   "writes parts with the textures of the scan."},
  {"segment_mesh bear.off --hulls hulls", "writes convex collision shapes."},
  {"segment_mesh bear.off --urdf bear.urdf --mjcf bear.xml --hull-vertices 64",
   "writes the parts with mass and inertia for simulators."},
  {"segment_mesh folder --out-dir results --outputs labels,html --time-limit 60",
   "segments many meshes, and leaves out those that were finished before."}};

struct Exit_status
{
  Status status;
  const char* meaning;
};

const Exit_status exit_statuses[] = {
  {Status::OK, "success"}, {Status::BUG, "a bug"}, {Status::USAGE, "wrong usage"},
  {Status::INPUT, "an input cannot be opened"}, {Status::MESH, "an input has no mesh"},
  {Status::MEMORY, "lack of memory"}, {Status::TIME, "the time limit was reached"},
  {Status::OUTPUT, "an output cannot be written"},
  {Status::SOME_FAILED, "runs of --out-dir failed"}};

inline std::string number_of(const Exit_status& s)
{ return std::to_string(static_cast<int>(s.status)); }

// Returns the options that have a group, because those without one are not shown.
inline std::vector<const CLI::Option*> documented_options(const CLI::App& app)
{
  return app.get_options([](const CLI::Option* option) { return !option->get_group().empty(); });
}

// Returns the names of an option, such as -o.
inline std::vector<std::string> names_of(const CLI::Option& option)
{
  std::vector<std::string> result;
  for (const std::string& name : option.get_snames())
    result.push_back('-' + name);
  for (const std::string& name : option.get_lnames())
    result.push_back("--" + name);
  return result;
}

// Returns the word for the value of an option, such as FILE; it is empty for a flag.
inline std::string value_name(const CLI::Option& option)
{
  const std::string type = option.get_type_name();
  return option.get_items_expected_max() > 0 ? type.substr(0, type.find(':')) : std::string();
}

// Returns the words that an option takes, which CLI11 writes as TYPE:{first,second}.
inline std::vector<std::string> choices_of(const CLI::Option& option)
{
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find(":{"), end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos)
    return {};
  return CLI::detail::split(type.substr(begin + 2, end - begin - 2), ',');
}

// Returns the description of an option with its choices and its default.
inline std::string description_of(const CLI::Option& option)
{
  std::string result = option.get_description();
  const std::vector<std::string> choices = choices_of(option);
  if (!choices.empty())
    result += "; one of " + CLI::detail::join(choices, ", ");
  if (!option.get_default_str().empty())
    result += " [" + CLI::detail::trim_copy(option.get_default_str()) + "]";
  return result;
}

// Breaks a text into lines of at most `width` bytes, unless a word is longer.
inline std::string wrapped(const std::string& text, std::size_t width)
{
  std::istringstream words(text);
  std::string result, word;
  for (std::size_t column = 0; words >> word; column += word.size()) {
    if (column > 0 && column + 1 + word.size() > width) {
      result += '\n';
      column = 0;
    }
    else if (column > 0) {
      result += ' ';
      ++column;
    }
    result += word;
  }
  return result;
}

// Writes the help for a terminal of 80 columns.
class Help_formatter : public CLI::Formatter
{
  static constexpr std::size_t width_ = 80, column_ = 28;

public:
  Help_formatter() { column_width(column_); }

  std::string make_option_opts(const CLI::Option* option) const override
  { return value_name(*option).empty() ? "" : ' ' + value_name(*option); }

  std::string make_option_desc(const CLI::Option* option) const override
  { return wrapped(description_of(*option), width_ - column_); }

  std::string make_footer(const CLI::App*) const override
  {
    std::string result = "Examples:\n", statuses;
    for (const Example& e : examples)
      result += std::string("  ") + e.command + "\n      " + e.effect + '\n';
    for (const Exit_status& s : exit_statuses)
      statuses += (statuses.empty() ? "" : ", ") + number_of(s) + ' ' + s.meaning;
    return result + "\nExit status:\n  " +
           CLI::detail::find_and_replace(wrapped(statuses, width_ - 2), "\n", "\n  ") + '\n';
  }
};

// Returns the manual page, in the language of man(1).
inline std::string man_page(const CLI::App& app)
{
  const auto escaped = [](const std::string& text) {
    std::string result;
    for (char c : text)
      result += c == '\\' ? std::string("\\e") : c == '-' ? std::string("\\-") : std::string(1, c);
    return result;
  };
  const auto entry = [](const std::string& heading, const std::string& text)
  { return ".TP\n" + heading + '\n' + text + '\n'; };
  std::string options, example_list, statuses;
  for (const std::string& group : app.get_groups()) {
    if (group.empty())
      continue;
    options += ".SS " + group + '\n';
    for (const CLI::Option* option : documented_options(app)) {
      if (option->get_group() != group)
        continue;
      std::string heading;
      for (const std::string& name : names_of(*option))
        heading += (heading.empty() ? "\\fB" : ", \\fB") + escaped(name) + "\\fR";
      if (option->get_positional())
        heading = "\\fI" + escaped(option->get_name(true)) + "\\fR";
      else if (!value_name(*option).empty())
        heading += " \\fI" + escaped(value_name(*option)) + "\\fR";
      options += entry(heading, escaped(description_of(*option)));
    }
  }
  for (const Example& e : examples)
    example_list += entry(std::string("\\fB") + escaped(e.command) + "\\fR", escaped(e.effect));
  for (const Exit_status& s : exit_statuses)
    statuses += entry(number_of(s), escaped(s.meaning));
  return ".TH SEGMENT_MESH 1 \"\" \"segment_mesh " CGAL_SPECTRAL_SEGMENTATION_VERSION "\"\n"
         ".SH NAME\nsegment_mesh \\- cuts a mesh into the parts that a person would name\n"
         ".SH SYNOPSIS\n.B segment_mesh\n\\fIIN\\fR ... [\\fIoptions\\fR]\n"
         ".SH DESCRIPTION\n"
         "Reads a mesh or polygon soup, finds its parts, such as legs, fingers, a handle or a lid, "
         "and writes them in the formats that the options ask for. Without an output it prints a "
         "summary. The number of parts need not be given. The same input gives the same parts on "
         "every run, with any number of threads.\n"
         ".SH OPTIONS\n" + options +
         ".SH EXIT STATUS\n" + statuses +
         "The reports of " + escaped("--json") + " have the status by name.\n"
         ".SH EXAMPLES\n" + example_list;
}

// Returns the completion for bash: names of options, their choices, and else names of files.
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

// Returns how many characters must be changed, inserted or left out (Levenshtein 1966).
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

// Returns the name of an option that may have been meant; empty if none is like it.
inline std::string similar_option(const CLI::App& app, std::string word)
{
  static const std::map<std::string, std::string> synonyms{ // of other programs
    {"--output", "-o"}, {"--out", "-o"}, {"-n", "--segments"}, {"-k", "--segments"},
    {"--parts", "--segments"}, {"--clusters", "--segments"}, {"--number", "--segments"},
    {"--max", "--maximum-segments"}, {"-t", "--salience-threshold"},
    {"--threshold", "--salience-threshold"}, {"-j", "--jobs"}, {"--format", "--split-format"},
    {"--split", "--split-dir"}, {"--watertight", "--close"}, {"--convex", "--hulls"},
    {"--flip", "--reverse"}, {"--timeout", "--time-limit"}, {"-q", "--quiet"}, {"-v", "--version"}};
  word = word.substr(0, word.find('='));
  if (const auto found = synonyms.find(word); found != synonyms.end())
    return found->second;
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
