// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <type_traits>

#include "sensor_msgs/msg/image.hpp"

// What the guide uses of rclcpp, written anew: one process, topics by name, a message is delivered where it is
// published.
namespace rclcpp {

class Time {
 public:
  explicit Time(const builtin_interfaces::msg::Time& time) : nanoseconds_(1000000000LL * time.sec + time.nanosec) {}
  std::int64_t nanoseconds() const { return nanoseconds_; }

 private:
  std::int64_t nanoseconds_;
};

struct QoS {
  QoS(int) {}
};
struct SensorDataQoS : QoS {
  SensorDataQoS() : QoS(5) {}
};

template <typename Message>
std::map<std::string, std::function<void(std::shared_ptr<const Message>)>>& topics() {
  static std::map<std::string, std::function<void(std::shared_ptr<const Message>)>> all;
  return all;
}

template <typename Message>
struct Subscription {
  using SharedPtr = std::shared_ptr<Subscription>;
};

template <typename Message>
struct Publisher {
  using SharedPtr = std::shared_ptr<Publisher>;
  void publish(const Message& message) const {
    const auto found = topics<Message>().find(topic);
    if (found != topics<Message>().end()) found->second(std::make_shared<const Message>(message));
  }
  std::string topic;
};

struct Logger {};
inline int& warnings() {
  static int count = 0;
  return count;
}

class Node {
 public:
  explicit Node(const std::string&) {}
  Logger get_logger() const { return {}; }

  template <typename Message, typename Callback>
  typename Subscription<Message>::SharedPtr create_subscription(const std::string& topic, const QoS&, Callback call) {
    topics<Message>()[topic] = [call](std::shared_ptr<const Message> message) {
      if constexpr (std::is_invocable_v<Callback, const Message&>)
        call(*message);
      else
        call(message);
    };
    return std::make_shared<Subscription<Message>>();
  }
  template <typename Message>
  typename Publisher<Message>::SharedPtr create_publisher(const std::string& topic, const QoS&) {
    return std::make_shared<Publisher<Message>>(Publisher<Message>{topic});
  }
};

inline std::string& folder() {
  static std::string name;
  return name;
}
inline void init(int argc, char** argv) { folder() = argc > 1 ? argv[1] : ""; }
inline void shutdown() {}

/// Plays the recording and ends the process.
void play(const std::string& sequence);
inline void spin(const std::shared_ptr<Node>&) { play(folder()); }

}  // namespace rclcpp

#define RCLCPP_WARN(logger, ...) \
  ((void)(logger), ++rclcpp::warnings(), std::printf("warning: " __VA_ARGS__), std::printf("\n"))
#define RCLCPP_ERROR(logger, ...) ((void)(logger), std::printf("error: " __VA_ARGS__), std::printf("\n"))
