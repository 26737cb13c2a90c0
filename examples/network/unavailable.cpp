// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// Stands in for network.cpp where OpenCV has no dnn module.

#include "network.hpp"
#include "sequence/errors.hpp"

namespace network {

Network open_network(const NetworkOptions&, cv::Size) {
  throw runner::UsageError(
      "--network: this program was built without OpenCV's dnn module (Debian and Ubuntu: libopencv-dnn-dev)");
}

}  // namespace network
