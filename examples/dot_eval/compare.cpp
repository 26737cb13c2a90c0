// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "compare.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <exception>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "dot/tracker.hpp"
#include "peers/rule.hpp"
#include "pool.hpp"
#include "progress.hpp"
#include "sequence/errors.hpp"
#include "sequence/sequence.hpp"
#include "text_table.hpp"

namespace eval {
namespace {

cv::Mat to_grey(const cv::Mat& image) {
  if (image.channels() == 1) return image;
  cv::Mat grey;
  cv::cvtColor(image, grey, image.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
  return grey;
}

cv::Mat to_metres(const runner::SequenceFrame& frame) {
  cv::Mat metres = frame.depth;
  if (frame.depth.depth() != CV_32F) frame.depth.convertTo(metres, CV_32F, 1 / frame.depth_units_per_metre);
  return metres;
}

peers::View view_of(const runner::SequenceFrame& frame, const dot::Result& result, const Eigen::Matrix4d& T) {
  peers::View view;
  view.grey = to_grey(frame.image);
  view.depth = to_metres(frame);
  view.ids.create(view.grey.size(), CV_32SC1);
  for (int y = 0; y < view.ids.rows; ++y)
    for (int x = 0; x < view.ids.cols; ++x) view.ids.at<int>(y, x) = static_cast<int>(result.ids(x, y));
  view.T_world_camera = dot::SE3d{T.topLeftCorner<3, 3>(), T.topRightCorner<3, 1>()}.normalized();
  return view;
}

/// The tracker's result with other states.
class Decided {
 public:
  Decided(const dot::Result& result, const peers::Answers& answers)
      : result_(result),
        objects_(result.objects.begin(), result.objects.end()),
        labels_(result.labels.height, result.labels.width, CV_8UC1) {
    const auto state_of = [&](std::uint32_t id) {
      const auto answer = answers.find(id);
      return answer == answers.end() ? dot::State::NotObservable : answer->second;
    };
    for (dot::ObjectResult& object : objects_) object.state = state_of(object.id);
    for (int y = 0; y < labels_.rows; ++y)
      for (int x = 0; x < labels_.cols; ++x)
        labels_.at<std::uint8_t>(y, x) =
            static_cast<std::uint8_t>(result.ids(x, y) == 0 ? dot::State::Background : state_of(result.ids(x, y)));
    result_.objects = {objects_.data(), objects_.size()};
    result_.labels = {labels_.ptr<std::uint8_t>(), labels_.cols, labels_.rows,
                      static_cast<std::ptrdiff_t>(labels_.step)};
  }
  Decided(const Decided&) = delete;
  Decided& operator=(const Decided&) = delete;

  const dot::Result& result() const { return result_; }

 private:
  dot::Result result_;
  std::vector<dot::ObjectResult> objects_;
  cv::Mat labels_;
};

struct Sources {
  std::vector<std::string> names{"dot"};
  std::vector<std::string> texts{"this library; it estimates the camera's motion itself"};
};

Sources sources() {
  Sources s;
  for (const peers::PublishedRule& rule : peers::published_rules({})) {
    s.names.push_back(rule.name);
    s.texts.push_back(rule.source);
  }
  return s;
}

/// @return the score of the tracker, then of each rule.
std::vector<ObjectScore> run(const Arguments& arguments, const std::filesystem::path& folder, const FrameDone& done) {
  runner::SequenceOptions source = arguments.run.sequence;
  source.folder = folder;
  source.mask_every = arguments.rates[0];
  source.truth = true;
  runner::Sequence sequence(source);
  const std::vector<runner::RecordingEntry>& entries = sequence.recording().entries;
  for (const runner::RecordingEntry& entry : entries)
    if (!entry.truth.camera) throw runner::FileError(folder.string() + ": --compare needs the true pose of each frame");
  if (std::all_of(entries.begin(), entries.end(), [](auto& entry) { return entry.truth.instance.empty(); }))
    throw runner::FileError(folder.string() + ": --compare needs true instances");
  dot::Tracker tracker(sequence.intrinsics(), tracker_options(arguments.run, sequence.depth_source()));
  std::vector<peers::PublishedRule> rules = peers::published_rules(sequence.intrinsics());
  std::vector<ObjectScorer> scorers(1 + rules.size(), ObjectScorer(arguments.scoring));

  for (int i = 0; i < sequence.size(); ++i) {
    const auto index = static_cast<std::size_t>(i);
    const runner::RecordingEntry& entry = entries[index];
    const runner::TruthEntry* const previous = i > 0 ? &entries[index - 1].truth : nullptr;
    const runner::SequenceFrame frame = sequence.read(i);
    const runner::FrameTruth truth = sequence.truth(i);
    const dot::Result& result = tracker.track(frame.frame());
    scorers[0].add(entry, truth, previous, result);
    const peers::View view = view_of(frame, result, *entry.truth.camera);
    for (std::size_t r = 0; r < rules.size(); ++r) {
      const Decided decided(result, rules[r].rule->next(view));
      scorers[1 + r].add(entry, truth, previous, decided.result());
    }
    done(i + 1, sequence.size());
  }
  std::vector<ObjectScore> scores;
  scores.reserve(scorers.size());
  for (const ObjectScorer& scorer : scorers) scores.push_back(scorer.score());
  return scores;
}

}  // namespace

std::vector<Contender> compare(const Arguments& arguments) {
  const Sources all = sources();
  std::vector<Contender> contenders;
  for (std::size_t i = 0; i < all.names.size(); ++i) contenders.push_back({all.names[i], all.texts[i], {}});
  Progress progress(static_cast<int>(arguments.sequences.size()));
  for (std::size_t i = 0; i < arguments.sequences.size(); ++i) {
    const std::string& name = arguments.names[i];
    std::vector<ObjectScore> scores;
    RunScore blank;
    blank.name = name;
    blank.every = arguments.rates[0];
    try {
      scores = run(arguments, arguments.sequences[i],
                   [&](int done, int total) { progress.frame(static_cast<int>(i), name, done, total); });
    } catch (const std::exception& error) {
      blank.error = error.what();
    }
    for (std::size_t c = 0; c < contenders.size(); ++c) {
      RunScore& score = contenders[c].runs.emplace_back(blank);
      if (!scores.empty()) score.objects = scores[c];
    }
    progress.finished(static_cast<int>(i), name, blank.error.empty() ? "compared" : "FAILED");
  }
  return contenders;
}

std::string compare_table(const std::vector<Contender>& contenders, int every) {
  const auto share = [](double value) { return number("%.3f", value); };
  Table pooled({"rule", "objfr", "F1", "prec", "recall", "decid", "st>mov", "kept", "IoU"});
  std::vector<std::string> header{"moving F1"};
  for (const RunScore& run : contenders[0].runs)
    if (run.error.empty()) header.push_back(run.name);
  Table by_sequence(header);
  std::string legend, errors;
  for (const Contender& contender : contenders) {
    const Pooled p = pool(contender.runs, every, every);
    const Confusion& c = p.confusion;
    pooled.add({contender.name, std::to_string(c.total()), share(c.f1()), share(c.precision()), share(c.recall()),
                share(c.decided_share()), share(c.static_moving_share()), share(c.static_kept_share()),
                share(p.mask_iou)});
    std::vector<std::string> row{contender.name};
    for (const RunScore& run : contender.runs)
      if (run.error.empty()) row.push_back(share(run.objects->confusion.f1()));
    by_sequence.add(std::move(row));
    legend += contender.name + ": " + contender.source + '\n';
  }
  for (const RunScore& run : contenders[0].runs)
    if (!run.error.empty()) errors += run.name + " FAILED: " + run.error + '\n';
  const std::string tables = header.size() > 1 ? pooled.text() + '\n' + by_sequence.text() + '\n' + legend : "";
  return tables + (errors.empty() || tables.empty() ? "" : "\n") + errors;
}

}  // namespace eval
