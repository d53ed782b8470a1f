// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_CHILD_RUNS_H
#define SEGMENT_MESH_CHILD_RUNS_H

#include "Failure.h"
#include "report.h"

#ifndef _WIN32
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
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

// Runs that go on at the same time, each in a process of its own, so that none harms another. Each
// has a number and ends with a result, or is ended by a signal. On Windows they run one after the
// other in this process.
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
    std::size_t number;
    int result; // the end of a pipe
  };

  std::map<pid_t, Child> children_;

  [[noreturn]] static void fail()
  { throw Failure(Status::BUG, "the system starts no further process"); }

  // The result is short, and so fits in the pipe before it is read.
  [[noreturn]] static void run_in_child(const Run& run, int descriptor, pid_t parent)
  {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGTERM); // so that it removes its temporary files
#endif
    if (getppid() != parent) // it died before
      _exit(1);
    const std::string result = run().dump(-1, ' ', false, Json::error_handler_t::replace);
    const bool is_sent = write(descriptor, result.data(), result.size()) > 0;
    _exit(is_sent ? 0 : 1); // without the destructors of what the parent still has
  }

  static std::string read_all(int descriptor)
  {
    std::string result;
    char buffer[4096];
    for (ssize_t size; (size = read(descriptor, buffer, sizeof buffer)) != 0;) {
      if (size < 0 && errno != EINTR)
        break;
      result.append(buffer, static_cast<std::size_t>(size > 0 ? size : 0));
    }
    close(descriptor);
    return result;
  }

public:
  Child_runs() { ::signal(SIGCHLD, SIG_DFL); } // a program that starts this one may ignore it
  Child_runs(const Child_runs&) = delete;
  Child_runs& operator=(const Child_runs&) = delete;

  ~Child_runs()
  {
    for (const auto& child : children_)
      kill(child.first, SIGTERM);
    while (!children_.empty())
      wait();
  }

  std::size_t size() const { return children_.size(); }

  // To be called before this process starts threads.
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
    children_[child] = {number, descriptors[0]};
  }

  // The next one to end.
  Ended_run wait()
  {
    int status = 0;
    pid_t process = 0;
    while ((process = waitpid(-1, &status, 0)) < 0 && errno == EINTR) {}
    const auto found = children_.find(process);
    const Child child = found->second;
    children_.erase(found);
    Ended_run result{child.number, std::nullopt, WIFSIGNALED(status) ? WTERMSIG(status) : 0};
    const Json sent = Json::parse(read_all(child.result), nullptr, false);
    if (!sent.is_discarded())
      result.result = sent;
    return result;
  }
#endif
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_CHILD_RUNS_H
