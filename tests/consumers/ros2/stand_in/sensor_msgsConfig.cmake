# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
add_library(sensor_msgs::sensor_msgs INTERFACE IMPORTED)
set_target_properties(sensor_msgs::sensor_msgs PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${CMAKE_CURRENT_LIST_DIR}")
set(sensor_msgs_TARGETS sensor_msgs::sensor_msgs)
