// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_READ_IN_CHILD_PROCESS_H
#define SEGMENT_MESH_READ_IN_CHILD_PROCESS_H

#include "write_all.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SEGMENT_MESH_IS_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SEGMENT_MESH_IS_SANITIZED
#endif
#endif

namespace segment_mesh {

// The limits of a child process.
struct Child_limits
{
  std::size_t memory; // in bytes, of address space; what it sends has at most this size, too
  double seconds;
};

// The end of a pipe at which the child process writes.
class Child_output
{
  int descriptor_;

public:
  explicit Child_output(int descriptor) : descriptor_(descriptor) {}

  template <class T>
  void send(const std::vector<T>& values)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::uint64_t size = values.size();
    write_all(descriptor_, &size, sizeof size);
    write_all(descriptor_, values.data(), values.size() * sizeof(T));
  }
};

// A child process for code that may crash, or use more memory or time than there is. It writes no
// file and nothing to the terminal, and it ends at the latest with this object.
//
// All functions throw `std::runtime_error`, with a message about the child.
class Child_process
{
  typedef std::chrono::steady_clock Clock;

  static constexpr int out_of_memory = 99; // the exit status for it

  const Child_limits limits_;
  const Clock::time_point start_ = Clock::now();
  std::size_t memory_left_ = limits_.memory; // left for received data
  int descriptor_ = -1;
  pid_t process_ = -1;

  static void lower_limit(int resource, double value)
  {
    rlimit limit;
    if (getrlimit(resource, &limit) != 0)
      return;
    if (limit.rlim_max == RLIM_INFINITY || value < static_cast<double>(limit.rlim_max))
      limit.rlim_max = static_cast<rlim_t>(value);
    limit.rlim_cur = limit.rlim_max;
    setrlimit(resource, &limit);
  }

  void set_limits() const
  {
#ifndef SEGMENT_MESH_IS_SANITIZED // sanitizers reserve more address space than any machine has
    lower_limit(RLIMIT_AS, static_cast<double>(limits_.memory));
#endif
    lower_limit(RLIMIT_CPU, std::ceil(limits_.seconds) + 1); // should the parent be stopped
    lower_limit(RLIMIT_CORE, 0);
    lower_limit(RLIMIT_FSIZE, 0);
    // Code that catches std::bad_alloc would take it for an error of the file.
    std::set_new_handler([] { _exit(out_of_memory); });
  }

  // Removes the parent's handlers of signals, which for example remove its files.
  static void forget_signal_handlers()
  {
    for (int i = 1; i < NSIG; ++i) {
      struct sigaction action;
      if (sigaction(i, nullptr, &action) == 0 && action.sa_handler != SIG_IGN)
        std::signal(i, SIG_DFL);
    }
  }

  static void die_with(pid_t parent)
  {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (getppid() != parent) // it died before
      _exit(EXIT_FAILURE);
  }

  static void silence_standard_streams()
  {
    const int null = open("/dev/null", O_RDWR);
    for (int i = 0; i < 3; ++i)
      if (null < 0 || dup2(null, i) < 0)
        _exit(EXIT_FAILURE);
  }

  template <class Function>
  [[noreturn]] void run(int descriptor, pid_t parent, Function& function) const
  {
    try {
      forget_signal_handlers();
      die_with(parent);
      descriptor = fcntl(descriptor, F_DUPFD, 3); // it is below if a standard stream was closed
      silence_standard_streams();
      set_limits();
      function(Child_output(descriptor));
    }
    catch (...) {
      _exit(EXIT_FAILURE);
    }
    _exit(EXIT_SUCCESS);
  }

  // Waits for the end of the child, and returns its status as waitpid() does.
  int wait()
  {
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {}
    process_ = -1;
    return status;
  }

  void end()
  {
    if (process_ >= 0) {
      kill(process_, SIGKILL);
      wait();
    }
    if (descriptor_ >= 0)
      close(descriptor_);
    descriptor_ = -1;
  }

  [[noreturn]] static void fail(const std::string& what)
  { throw std::runtime_error("the reader of this format " + what); }

  [[noreturn]] void fail_after_time() const
  {
    const std::string seconds = std::to_string(static_cast<long long>(std::ceil(limits_.seconds)));
    fail("took longer than " + seconds + " s");
  }

  // Throws the reason why the child has closed the pipe: it is dead, or about to be.
  [[noreturn]] void fail_after_end()
  {
    const int status = wait();
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
      fail_after_time();
    // The system kills where memory is short.
    if ((WIFEXITED(status) && WEXITSTATUS(status) == out_of_memory) ||
        (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL))
      fail("ran out of memory");
    fail("crashed");
  }

  // Waits until something can be read.
  void wait_for_data() const
  {
    while (true) {
      const double left =
        limits_.seconds - std::chrono::duration<double>(Clock::now() - start_).count();
      if (left <= 0)
        fail_after_time();
      pollfd request{descriptor_, POLLIN, 0};
      const int milliseconds = static_cast<int>((std::min)(1000 * left + 1, 1e6));
      const int number = poll(&request, 1, milliseconds);
      if (number > 0)
        return;
      if (number < 0 && errno != EINTR)
        fail("cannot be waited for");
    }
  }

  void receive(void* data, std::size_t size)
  {
    for (char* bytes = static_cast<char*>(data); size > 0;) {
      wait_for_data();
      const ssize_t number = read(descriptor_, bytes, size);
      if (number < 0 && errno == EINTR)
        continue;
      if (number <= 0)
        fail_after_end();
      bytes += number;
      size -= static_cast<std::size_t>(number);
    }
  }

public:
  // Starts a child that calls the function with a `Child_output`, and exits. The program must not
  // have threads yet.
  template <class Function>
  Child_process(const Child_limits& limits, Function function) : limits_(limits)
  {
    int descriptors[2];
    if (pipe(descriptors) != 0)
      fail("cannot be started");
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ == 0)
      run(descriptors[1], parent, function);
    close(descriptors[1]);
    descriptor_ = descriptors[0];
    if (process_ < 0) {
      end();
      fail("cannot be started");
    }
  }

  ~Child_process() { end(); }

  Child_process(const Child_process&) = delete;
  Child_process& operator=(const Child_process&) = delete;

  // Returns the next data from the child; a broken child may send anything.
  template <class T>
  std::vector<T> receive()
  {
    static_assert(std::is_trivially_copyable_v<T>);
    std::uint64_t size;
    receive(&size, sizeof size);
    if (size > memory_left_ / sizeof(T))
      fail("crashed");
    memory_left_ -= static_cast<std::size_t>(size) * sizeof(T);
    std::vector<T> result;
    result.reserve(static_cast<std::size_t>(size));
    // Memory is touched only for what comes.
    const std::size_t most = (std::size_t(1) << 20) / sizeof(T);
    while (result.size() < size) {
      const std::size_t received = result.size();
      result.resize((std::min)(static_cast<std::size_t>(size), received + most));
      receive(result.data() + received, (result.size() - received) * sizeof(T));
    }
    return result;
  }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_READ_IN_CHILD_PROCESS_H
