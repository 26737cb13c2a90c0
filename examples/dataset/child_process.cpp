// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "child_process.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <thread>
#include <utility>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "sequence/errors.hpp"

namespace dataset {
namespace {

/// Less than what a pipe takes without a reader.
constexpr std::size_t longest_reason = 2000;

void die_with(pid_t parent) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (getppid() != parent) std::_Exit(EXIT_FAILURE);  // it has died before that line
}

/// The copy's life.
[[noreturn]] void live(const std::function<void()>& work, int reason_out) {
  int status = EXIT_SUCCESS;
  std::string reason;
  try {
    work();
  } catch (const std::exception& error) {
    status = EXIT_FAILURE;
    reason = error.what();
  } catch (...) {
    status = EXIT_FAILURE;
    reason = "unknown error";
  }
  if (!reason.empty()) std::fprintf(stderr, "%s\n", reason.c_str());
  std::fflush(nullptr);
  reason.resize(std::min(reason.size(), longest_reason));
  if (write(reason_out, reason.data(), reason.size()) < 0) status = EXIT_FAILURE;
  std::_Exit(status);  // the parent's destructors are not the copy's to run
}

std::string read_all(int file) {
  std::string text;
  char buffer[512];
  for (ssize_t count; (count = read(file, buffer, sizeof buffer)) != 0;) {
    if (count < 0 && errno != EINTR) break;
    if (count > 0) text.append(buffer, static_cast<std::size_t>(count));
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

ChildProcess::ChildProcess(const std::function<void()>& work) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error(std::string("no pipe for a process: ") + std::strerror(errno));
  std::fflush(nullptr);  // or the copy would write it once more
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0) {
    const std::string why = std::strerror(errno);
    close(ends[0]), close(ends[1]);
    pid_ = 0;
    throw std::runtime_error("no process to be had: " + why);
  }
  if (pid_ == 0) {
    close(ends[0]);
    die_with(parent);
    live(work, ends[1]);
  }
  close(ends[1]);
  reason_in_ = ends[0];
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, 0)), reason_in_(std::exchange(other.reason_in_, -1)) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(reason_in_, other.reason_in_);
  return *this;
}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) continue;
  }
  if (reason_in_ >= 0) close(reason_in_);
}

std::optional<Ending> ChildProcess::ended() {
  int status = 0;
  const pid_t pid = waitpid(pid_, &status, WNOHANG);
  if (pid == 0 || (pid < 0 && errno == EINTR)) return std::nullopt;
  pid_ = 0;
  Ending ending;
  if (pid < 0) {
    ending.reason = std::string("how it has ended is not known: ") + std::strerror(errno);
    return ending;
  }
  ending.good = WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
  if (ending.good) return ending;
  ending.reason = read_all(reason_in_);
  if (WIFSIGNALED(status))
    ending.reason = "ended by signal " + std::to_string(WTERMSIG(status)) + ", " + strsignal(WTERMSIG(status));
  else if (ending.reason.empty())
    ending.reason = "ended with status " + std::to_string(WEXITSTATUS(status));
  return ending;
}

void ChildProcess::ask_to_stop() const {
  if (pid_ > 0) kill(pid_, SIGTERM);
}

namespace {

void lock(int file, const std::string& path, std::chrono::milliseconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (flock(file, LOCK_EX | LOCK_NB) != 0) {
    // A file system without locks has none to respect.
    if (errno != EWOULDBLOCK && errno != EINTR) break;
    if (std::chrono::steady_clock::now() > end)
      throw runner::FileError(path + ": another run is writing to this folder");
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

}  // namespace

void write_output_to(const std::string& path, std::chrono::milliseconds patience) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) throw runner::FileError(path + ": cannot be written: " + std::strerror(errno));
  lock(file, path, patience);
  std::fflush(nullptr);
  if (ftruncate(file, 0) != 0 || dup2(file, STDOUT_FILENO) < 0 || dup2(file, STDERR_FILENO) < 0)
    throw runner::FileError(path + ": cannot be written: " + std::strerror(errno));
  close(file);
}

void keep_output_file(const std::string& path, std::chrono::milliseconds patience) {
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file >= 0) lock(file, path, patience);
}

}  // namespace dataset
