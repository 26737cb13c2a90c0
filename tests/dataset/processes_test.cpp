// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dataset/processes.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>

#include "sequence/errors.hpp"
#include "support/recording_folder.hpp"

namespace dataset {
namespace {

std::map<std::size_t, Ending> run(int side_by_side, const std::vector<std::size_t>& jobs,
                                  const std::function<void(std::size_t)>& work) {
  std::map<std::size_t, Ending> endings;
  const std::atomic<bool> stop{false};
  Processes{side_by_side,
            work,
            [&](std::size_t job, const Ending& ending) {
              EXPECT_TRUE(endings.emplace(job, ending).second) << "job " << job << " has ended twice";
            },
            {}}
      .run(jobs, stop);
  return endings;
}

TEST(Processes, EachJobIsDoneOnce) {
  const RecordingFolder folder;
  for (const int side_by_side : {1, 3}) {
    const auto endings = run(side_by_side, {0, 1, 2, 3, 7}, [&](std::size_t job) {
      std::ofstream(folder.path() / std::to_string(job), std::ios::app) << "x";
    });
    EXPECT_EQ(endings.size(), 5U);
    for (const auto& [job, ending] : endings) {
      EXPECT_TRUE(ending.good) << ending.reason;
      std::ifstream stream(folder.path() / std::to_string(job));
      EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), side_by_side == 1 ? "x" : "xx");
    }
  }
}

TEST(Processes, AFailureIsToldAndDoesNotEndTheOthers) {
  const auto endings = run(2, {0, 1, 2, 3, 4}, [](std::size_t job) {
    if (job == 1) throw std::runtime_error("no such\nfolder");
    if (job == 2) raise(SIGKILL);
    if (job == 3) _exit(7);
  });
  ASSERT_EQ(endings.size(), 5U);
  EXPECT_TRUE(endings.at(0).good);
  EXPECT_TRUE(endings.at(4).good);
  EXPECT_FALSE(endings.at(1).good);
  EXPECT_EQ(endings.at(1).reason, "no such folder");
  EXPECT_FALSE(endings.at(2).good);
  EXPECT_EQ(endings.at(2).reason.find("ended by signal 9, "), 0U) << endings.at(2).reason;
  EXPECT_FALSE(endings.at(3).good);
  EXPECT_EQ(endings.at(3).reason, "ended with status 7");
}

TEST(Processes, NoJobsAreNoWork) {
  EXPECT_TRUE(run(4, {}, [](std::size_t) {}).empty());
}

TEST(Processes, WhenStoppedNoOtherBegins) {
  std::atomic<bool> stop{false};
  std::vector<std::size_t> ended;
  Processes{1,
            [](std::size_t) {},
            [&](std::size_t job, const Ending&) {
              ended.push_back(job);
              if (job == 1) stop = true;
            },
            {}}
      .run({0, 1, 2, 3}, stop);
  EXPECT_EQ(ended, (std::vector<std::size_t>{0, 1}));
}

TEST(Processes, ThoseThatRunAreAskedToEnd) {
  std::atomic<bool> stop{false};
  std::map<std::size_t, Ending> endings;
  // Job 0 ends and stops the others, which would wait for a signal for ever.
  Processes{2,
            [](std::size_t job) {
              if (job != 0) pause();
            },
            [&](std::size_t job, const Ending& ending) {
              endings[job] = ending;
              stop = true;
            },
            {}}
      .run({0, 1, 2}, stop);
  ASSERT_EQ(endings.size(), 2U);
  EXPECT_TRUE(endings[0].good);
  EXPECT_EQ(endings[1].reason.find("ended by signal 15, "), 0U) << endings[1].reason;
}

TEST(Processes, EndingsAreKnownWhereTheyWereIgnored) {
  std::signal(SIGCHLD, SIG_IGN);  // as whoever starts the program may leave it
  const auto endings = run(2, {0, 1}, [](std::size_t job) {
    if (job == 1) _exit(7);
  });
  std::signal(SIGCHLD, SIG_DFL);
  ASSERT_EQ(endings.size(), 2U);
  EXPECT_TRUE(endings.at(0).good);
  EXPECT_EQ(endings.at(1).reason, "ended with status 7");
}

TEST(ChildProcess, AnEndingThatIsNotKnownIsBad) {
  std::signal(SIGCHLD, SIG_IGN);
  ChildProcess process([] {});
  std::optional<Ending> ending;
  for (int i = 0; i < 6000 && !ending; ++i) {  // a minute
    ending = process.ended();
    if (!ending) usleep(10000);
  }
  std::signal(SIGCHLD, SIG_DFL);
  ASSERT_TRUE(ending);
  EXPECT_FALSE(ending->good);
  EXPECT_EQ(ending->reason.find("how it has ended is not known: "), 0U) << ending->reason;
}

TEST(ChildProcess, ALogHasOneWriter) {
  const RecordingFolder folder;
  const std::string log = (folder.path() / "run.log").string();
  folder.text("run.log", "of an earlier run, which was longer");
  const auto endings = run(1, {0}, [&](std::size_t) {
    write_output_to(log);
    std::printf("out\n");
    std::fflush(stdout);
    std::fprintf(stderr, "err\n");
  });
  EXPECT_TRUE(endings.at(0).good) << endings.at(0).reason;
  std::ifstream stream(log);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "out\nerr\n");

  // While job 0 keeps it, job 1 does not get it; job 0 is killed then.
  int to_tell[2];
  ASSERT_EQ(pipe(to_tell), 0);
  std::map<std::size_t, Ending> ends;
  std::atomic<bool> stop{false};
  Processes{2,
            [&](std::size_t job) {
              char byte = 'x';
              if (job == 1 && read(to_tell[0], &byte, 1) != 1) throw std::runtime_error("no word of job 0");
              if (job == 1) return keep_output_file(log, std::chrono::milliseconds(0));
              write_output_to(log);
              if (job == 0 && write(to_tell[1], &byte, 1) == 1) pause();
            },
            [&](std::size_t job, const Ending& ending) {
              ends[job] = ending;
              stop = true;
            },
            {}}
      .run({0, 1}, stop);
  close(to_tell[0]), close(to_tell[1]);
  EXPECT_EQ(ends[1].reason, log + ": another run is writing to this folder");
}

}  // namespace
}  // namespace dataset
