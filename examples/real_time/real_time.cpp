// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "real_time.hpp"

#include <optional>
#include <variant>

#include "inbox.hpp"
#include "late_masks_feed.hpp"
#include "network_thread.hpp"

namespace real_time {
Report play(const Source& source, Clock& clock, std::atomic<bool>& stop, dot::Tracker& tracker,
            const ResultConsumer& done) {
  Report report;
  Inbox inbox;
  WriterThread writer(done);
  LateMasksFeed feed(tracker);
  std::optional<NetworkThread> network;
  if (source.network.segment) network.emplace(source.network.segment, source.network.seconds, clock, inbox);
  int received = 0;
  {
    const CameraThread camera(source.read, source.times, clock, stop, inbox);
    while (std::optional<Inbox::Item> item = inbox.take()) {
      if (const auto* late = std::get_if<LateSegmentation>(&*item)) {
        ++received;
        feed.submit(*late);
        continue;
      }
      const Arrival& arrival = std::get<Arrival>(*item);
      if (network && source.network.takes(*arrival.frame)) {
        network->offer(arrival);
        ++report.offered;
      }
      dot::Frame frame = arrival.frame->frame();
      frame.masks.reset();
      const double start = clock.now();
      const dot::Result& result = tracker.track(frame);
      const double end = clock.now();
      ++report.tracked;
      report.frame_latency.push_back(end - arrival.time);
      writer.put(arrival.frame, result, 1000 * (end - start));
    }
    report.late_reads = camera.late();
  }
  writer.finish();
  report.frames = report.tracked + inbox.dropped();
  report.refused = feed.refused();
  report.mask_latency = feed.latencies();
  if (network) {
    report.skipped = network->skipped();
    report.unfinished = report.offered - report.skipped - received;
  }
  return report;
}

}  // namespace real_time
