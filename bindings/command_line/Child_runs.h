// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_CHILD_RUNS_H
#define SEGMENT_MESH_CHILD_RUNS_H

#include "../meshes/Failure.h"
#include "report.h"

#ifndef _WIN32
#include "../files/write_all.h"

#include <poll.h>
#include <signal.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>
#endif
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

// Runs that go on at the same time, each in a process of its own, so that none harms another. Each
// has a number, and ends with a result or by a signal. On Windows they run in this process, one
// after the other.
class Child_runs
{
public:
  typedef std::function<Json()> Run;

  struct Ended_run
  {
    std::size_t number;
    std::optional<Json> result; // none if a signal ended it
    int signal;
  };

#ifdef _WIN32
private:
  std::vector<Ended_run> ended_;

public:
  std::size_t size() const { return ended_.size(); }

  void start(std::size_t number, const Run& run) { ended_.push_back({number, run(), 0}); }

  Ended_run wait()
  {
    Ended_run result = std::move(ended_.back());
    ended_.pop_back();
    return result;
  }
#else
private:
  struct Child
  {
    pid_t process;
    std::size_t number;
    int descriptor;     // the end of a pipe
    std::string result; // what has come out of it
  };

  std::vector<Child> children_;

  [[noreturn]] static void fail()
  { throw Failure(Status::BUG, "the system starts no further process"); }

  [[noreturn]] static void run_in_child(const Run& run, int descriptor, pid_t parent)
  {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGTERM); // so that it removes its temporary files
#endif
    if (getppid() != parent) // it died before
      _exit(1);
    const std::string result = run().dump(-1, ' ', false, Json::error_handler_t::replace);
    write_all(descriptor, result.data(), result.size());
    _exit(0); // runs no destructors, because the parent still has the objects
  }

  // Reads what a child has sent, and returns whether the child has closed its end.
  static bool read_some(Child& child)
  {
    char buffer[4096];
    const ssize_t size = read(child.descriptor, buffer, sizeof buffer);
    if (size > 0)
      child.result.append(buffer, static_cast<std::size_t>(size));
    return size == 0 || (size < 0 && errno != EINTR);
  }

  // Returns the place of a child that has closed its end of the pipe, and reads what all send until
  // then: a child with a long result does not end before.
  std::size_t next_to_end()
  {
    while (true) {
      std::vector<pollfd> requests;
      for (const Child& child : children_)
        requests.push_back({child.descriptor, POLLIN, 0});
      if (poll(requests.data(), static_cast<nfds_t>(requests.size()), -1) < 0 && errno != EINTR)
        throw Failure(Status::BUG, "the system does not tell when a process ends");
      for (std::size_t i = 0; i < requests.size(); ++i)
        if (requests[i].revents != 0 && read_some(children_[i]))
          return i;
    }
  }

  // Waits for the end of a child that has closed its end of the pipe. This process may have other
  // children, which are not touched.
  Ended_run end(std::size_t i)
  {
    const Child child = std::move(children_[i]);
    children_.erase(children_.begin() + static_cast<std::ptrdiff_t>(i));
    close(child.descriptor);
    int status = 0;
    while (waitpid(child.process, &status, 0) < 0 && errno == EINTR) {}
    Ended_run result{child.number, std::nullopt, WIFSIGNALED(status) ? WTERMSIG(status) : 0};
    Json sent = Json::parse(child.result, nullptr, false);
    if (!sent.is_discarded())
      result.result = std::move(sent);
    return result;
  }

public:
  Child_runs() { ::signal(SIGCHLD, SIG_DFL); } // a program that starts this one may ignore it
  Child_runs(const Child_runs&) = delete;
  Child_runs& operator=(const Child_runs&) = delete;

  ~Child_runs()
  {
    for (const Child& child : children_)
      kill(child.process, SIGTERM);
    while (!children_.empty())
      end(children_.size() - 1);
  }

  std::size_t size() const { return children_.size(); }

  // Starts a run in a child. This process must not have threads yet.
  void start(std::size_t number, const Run& run)
  {
    int descriptors[2];
    if (pipe(descriptors) != 0)
      fail();
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child == 0) {
      close(descriptors[0]);
      run_in_child(run, descriptors[1], parent);
    }
    close(descriptors[1]);
    if (child < 0) {
      close(descriptors[0]);
      fail();
    }
    children_.push_back({child, number, descriptors[0], ""});
  }

  // Returns the next run to end.
  Ended_run wait() { return end(next_to_end()); }
#endif
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_CHILD_RUNS_H
