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
  NetworkThread network(source.network.segment, source.network.seconds, clock, inbox);
  {
    const CameraThread camera(source.read, source.times, clock, stop, inbox);
    while (std::optional<Inbox::Item> item = inbox.take()) {
      if (const auto* late = std::get_if<LateSegmentation>(&*item)) {
        feed.submit(*late);
        continue;
      }
      const Arrival& arrival = std::get<Arrival>(*item);
      if (source.network.takes(*arrival.frame)) {
        network.offer(arrival);
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
  network.finish();
  inbox.check();  // what failed after the last frame was taken
  writer.finish();
  report.frames = report.tracked + inbox.dropped();
  report.refused = feed.refused();
  report.mask_latency = feed.latencies();
  report.skipped = network.skipped();
  return report;
}

}  // namespace real_time
