// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_CHECK_OUTPUTS_H
#define SEGMENT_MESH_CHECK_OUTPUTS_H

#include "../meshes/Failure.h"

#include <nlohmann/json.hpp>

#ifndef _WIN32
#include <sys/stat.h>
#include <unistd.h>
#endif

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace segment_mesh {

typedef std::filesystem::path Path;

[[noreturn]] inline void throw_cannot_write(const Path& name, const std::string& reason = "")
{
  throw Failure(Status::OUTPUT,
                "cannot write " + name.string() + (reason.empty() ? "" : ": ") + reason);
}

inline bool is_standard_output(const Path& name) { return name == "-" || name == "/dev/stdout"; }

inline std::filesystem::file_status status_of(const Path& name)
{
  std::error_code error;
  const std::filesystem::file_status result = std::filesystem::status(name, error);
  if (!status_known(result))
    throw_cannot_write(name, error.message());
  return result;
}

// Returns whether a name is that of a pipe, a device or standard output, and not of a file.
inline bool is_stream(const Path& name)
{
  return is_standard_output(name) || is_character_file(status_of(name)) ||
         is_fifo(status_of(name));
}

// Returns the file at the end of links, which need not exist.
inline Path behind_links(Path name)
{
  std::error_code ignored;
  const int most_links = 40; // as Linux has it
  for (int i = 0; i < most_links && std::filesystem::is_symlink(name, ignored); ++i)
    name = name.parent_path() / std::filesystem::read_symlink(name, ignored);
  return name;
}

inline Path directory_of(const Path& name)
{ return name.has_parent_path() ? name.parent_path() : "."; }

inline bool is_writable([[maybe_unused]] const Path& name)
{
#ifdef _WIN32
  return true;
#else
  return access(name.c_str(), W_OK) == 0;
#endif
}

// Returns whether nobody may write to a file, or this user may not. The superuser may write to all
// files, but does not mean to write to write-protected ones.
inline bool is_write_protected(const Path& file)
{
  using std::filesystem::perms;
  const perms write = perms::owner_write | perms::group_write | perms::others_write;
  return !is_writable(file) ||
         (std::filesystem::status(file).permissions() & write) == perms::none;
}

// Returns whether this user may not replace a file, because its directory is one such as /tmp,
// where only the owner of the file or of the directory may.
inline bool is_kept_by_sticky_bit([[maybe_unused]] const Path& file)
{
#ifdef _WIN32
  return false;
#else
  struct stat status, status_of_directory;
  const uid_t user = geteuid();
  return user != 0 && lstat(file.c_str(), &status) == 0 &&
         stat(directory_of(file).c_str(), &status_of_directory) == 0 &&
         (status_of_directory.st_mode & S_ISVTX) != 0 && status.st_uid != user &&
         status_of_directory.st_uid != user;
#endif
}

inline void check_directory(const Path& name, const Path& directory)
{
  std::error_code ignored;
  if (!std::filesystem::is_directory(directory, ignored))
    throw_cannot_write(name, "there is no directory " + directory.string());
  if (!is_writable(directory))
    throw_cannot_write(name, "there is no permission to write to the directory " +
                               directory.string());
}

// Throws `Failure` if no file of this name can be made or replaced.
inline void check_output_name(const Path& name)
{
  if (is_standard_output(name))
    return;
  const std::filesystem::file_status status = status_of(name);
  const Path file = behind_links(name);
  if (exists(status) ? !is_regular_file(status) && !is_stream(name) : !file.has_filename())
    throw_cannot_write(name, "it is not a file");
  if (exists(status) && is_write_protected(name))
    throw_cannot_write(name, "it is write-protected");
  if (is_stream(name))
    return;
  check_directory(name, directory_of(file));
  if (is_kept_by_sticky_bit(file))
    throw_cannot_write(name, "only its owner may replace it");
}

inline bool is_same_place(const Path& a, const Path& b)
{
  std::error_code ignored;
  return a.filename() == b.filename() &&
         std::filesystem::equivalent(directory_of(a), directory_of(b), ignored);
}

// Returns whether two names are of one file or directory, through links of any kind.
inline bool is_same_file(const Path& a, const Path& b)
{
  std::error_code ignored;
  return (std::filesystem::is_regular_file(a, ignored) ||
          std::filesystem::is_directory(a, ignored)) &&
         std::filesystem::equivalent(a, b, ignored);
}

inline bool is_same_output(const Path& a, const Path& b)
{
  const auto file = [](const Path& name) { return name == "-" ? Path("/dev/stdout") : name; };
  return (is_standard_output(a) && is_standard_output(b)) || is_same_file(file(a), file(b)) ||
         (!is_stream(a) && is_same_place(behind_links(a), behind_links(b)));
}

// The index of a directory of segments, by which a later run knows what it may remove.
const char* const segment_index_name = "segments.json";

// Returns whether a name is like segment_000.ply, segment_1000.obj or texture_000.png.
inline bool is_segment_file(const std::string& name)
{
  const std::string start = name.substr(0, 8); // which are equally long
  const std::size_t dot = name.find_first_not_of("0123456789", start.size());
  return (start == "segment_" || start == "texture_") && dot != std::string::npos &&
         dot >= start.size() + 3 && name[dot] == '.' &&
         name.find_first_of("./\\", dot + 1) == std::string::npos;
}

// The begin and end of the name of a file while it is written, which are short so that the target
// may have the longest possible name.
const std::string temporary_start = ".segment_mesh_", temporary_end = ".tmp";
constexpr std::size_t number_of_temporary_digits = 16;

// Returns whether a name is that of a temporary file, which only a run that was killed leaves.
inline bool is_temporary_file(const std::string& name)
{
  const std::size_t end = temporary_start.size() + number_of_temporary_digits;
  return name.size() == end + temporary_end.size() &&
         name.compare(0, temporary_start.size(), temporary_start) == 0 &&
         name.find_first_not_of("0123456789abcdef", temporary_start.size()) == end &&
         name.compare(end, temporary_end.size(), temporary_end) == 0;
}

inline std::string segment_index(const std::set<std::string>& files,
                                 const nlohmann::ordered_json& closed_segments)
{
  nlohmann::ordered_json result = {{"writer", "segment_mesh"}, {"files", files}};
  if (!closed_segments.empty())
    result["closed_segments"] = closed_segments;
  return result.dump(1) + "\n";
}

// Returns the files of segments that an earlier run wrote, and the temporary files of runs that
// were killed; none if the directory does not exist yet. Throws if the directory or one of these
// files cannot be written to, or the directory may be of another use.
inline std::set<std::string> earlier_segment_files(const Path& directory)
{
  const std::filesystem::file_status status = status_of(directory);
  if (exists(status) && !is_directory(status))
    throw_cannot_write(directory, "it is not a directory");
  check_directory(directory, exists(status) ? directory : directory_of(directory));
  std::set<std::string> result;
  if (!exists(status))
    return result;
  bool has_index = false;
  const Path index_file = directory / segment_index_name;
  if (exists(status_of(index_file)) && !is_regular_file(status_of(index_file)))
    throw_cannot_write(index_file, "it is not a file");
  check_output_name(index_file);
  try {
    std::ifstream in(index_file);
    const nlohmann::json index = nlohmann::json::parse(in);
    for (const std::string& name : index.at("files").get<std::vector<std::string> >())
      if (is_segment_file(name))
        result.insert(name);
    has_index = index.at("writer") == "segment_mesh";
  }
  catch (const nlohmann::json::exception&) {
  }
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename().string();
    if (is_temporary_file(name))
      result.insert(name);
    else if (!has_index || (is_segment_file(name) && result.count(name) == 0))
      throw_cannot_write(directory, "its file " + name + " is not of an earlier run; name a new "
                                      "or an empty directory");
  }
  if (error)
    throw_cannot_write(directory, error.message());
  for (const std::string& name : result)
    check_output_name(directory / name);
  return result;
}

inline Path split_directory_of(const Path& name)
{ return behind_links(name.has_filename() ? name : name.parent_path()); }

// Throws before a long run what could not be written after it. An input or output may be "-"; an
// output and a directory of segments may be empty for none.
inline void check_outputs(const std::vector<Path>& inputs, const std::vector<Path>& outputs,
                          const std::vector<Path>& split_directories)
{
  const auto check_inputs = [&](const Path& name) {
    for (const Path& input : inputs)
      if (is_same_file(name, input == "-" ? "/dev/stdin" : input))
        throw Failure(Status::USAGE, name.string() + " is the input");
  };
  std::vector<Path> checked;
  const auto check_clash = [&](const Path& name) {
    for (const Path& other : checked)
      if (is_same_output(other, name))
        throw Failure(Status::USAGE, "two outputs have the name " + name.string());
  };
  for (const Path& name : outputs) {
    if (name.empty())
      continue;
    check_output_name(name);
    check_inputs(name);
    check_clash(name);
    checked.push_back(name);
  }
  for (const Path& split_directory : split_directories) {
    if (split_directory.empty())
      continue;
    const Path directory = split_directory_of(split_directory);
    check_clash(directory);
    for (const std::string& name : earlier_segment_files(directory)) {
      check_inputs(directory / name);
      check_clash(directory / name);
    }
    for (const Path& other : checked) {
      const std::string name = behind_links(other).filename().string();
      if (is_segment_file(name) || name == segment_index_name)
        check_clash(directory / name);
    }
    checked.push_back(directory);
  }
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_CHECK_OUTPUTS_H
