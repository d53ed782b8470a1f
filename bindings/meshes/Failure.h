// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_FAILURE_H
#define SEGMENT_MESH_FAILURE_H

#include <exception>
#include <new>
#include <stdexcept>
#include <string>

namespace segment_mesh {

// How a run ended: the exit status of the program.
enum class Status { OK, BUG, USAGE, INPUT, MESH, MEMORY, TIME, OUTPUT, SOME_FAILED };

// Returns the name of a status in reports.
inline const char* name_of(Status status)
{
  switch (status) {
    case Status::OK: return "ok";
    case Status::USAGE: return "usage";
    case Status::INPUT: return "input";
    case Status::MESH: return "mesh";
    case Status::MEMORY: return "memory";
    case Status::TIME: return "time";
    case Status::OUTPUT: return "output";
    case Status::SOME_FAILED: return "some failed";
    default: return "bug";
  }
}

// Ends a run with an error message.
struct Failure : std::runtime_error
{
  Status status;

  Failure(Status status, const std::string& sentence)
    : std::runtime_error(sentence), status(status) {}
};

// Returns the failure that a handler has caught. An exception that has no status is a bug.
inline Failure current_failure(const std::string& input)
{
  try {
    throw;
  }
  catch (const Failure& failure) {
    return failure;
  }
  catch (const std::bad_alloc&) {
    return Failure(Status::MEMORY, "there is not enough memory for " + input);
  }
  catch (const std::exception& e) {
    return Failure(Status::BUG, e.what());
  }
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_FAILURE_H
