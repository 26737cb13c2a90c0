# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# JSON and HTML that dot_eval wrote of the sample and of a sequence that failed, at the rates 1 and 4.

file(READ "${OUT}/eval.json" json)
string(JSON count LENGTH "${json}" runs)
if(NOT count EQUAL 4)
  message(FATAL_ERROR "eval.json has ${count} runs, expected 4")
endif()

# Fails where the path does not exist.
foreach(key IN ITEMS moving_f1 moving_mask_iou instance_iou_mean id_switches by_range_m by_true_speed_mps confusion pixels
                     stage_ms latency hidden_movers)
  string(JSON value GET "${json}" runs 0 ${key})
endforeach()
foreach(key IN ITEMS rpe_trans_cm rpe_rot_median_deg drift_percent ate_m stretches step_cm)
  string(JSON value GET "${json}" runs 0 camera ${key})
endforeach()
foreach(key IN ITEMS moving_f1 iou_ratio_min near_speed_error_mps turning static_nees_0-15 hidden_movers latency_median_s)
  string(JSON value GET "${json}" pooled 4 ${key})
endforeach()
string(JSON message GET "${json}" runs 1 error)
if(NOT message MATCHES "no such folder")
  message(FATAL_ERROR "the failed run says '${message}'")
endif()

# The sample shows parked and driving cars in perfect depth; masks in every frame.
string(JSON precision GET "${json}" runs 0 moving_precision)
string(JSON error GET "${json}" runs 0 camera rpe_trans_cm)
if(precision LESS 0.9 OR error GREATER 1)
  message(FATAL_ERROR "precision ${precision}, camera error ${error} cm a frame")
endif()

# What no mask shows is not found, unless discovery is on.
string(JSON movers GET "${json}" runs 0 hidden_movers movers)
string(JSON found GET "${json}" runs 0 hidden_movers found_share)
if(NOT movers EQUAL 1 OR found GREATER 0.5)
  message(FATAL_ERROR "${movers} hidden movers, of whose pixels ${found} are found")
endif()

# Every tag is closed by its own kind. Brackets and semicolons mean something to CMake's lists.
file(READ "${OUT}/eval.html" html)
string(REGEX REPLACE "[][;]" " " html "${html}")
string(REGEX MATCHALL "<[^<>]*>" tags "${html}")
set(open)
foreach(tag IN LISTS tags)
  if(tag MATCHES "^<!" OR tag MATCHES "/>$")
    continue()
  elseif(tag MATCHES "^</(.*)>$")
    set(name "${CMAKE_MATCH_1}")
    list(POP_BACK open last)
    if(NOT last STREQUAL name)
      message(FATAL_ERROR "eval.html: </${name}> where <${last}> is open")
    endif()
  elseif(tag MATCHES "^<([a-z0-9]+)")
    list(APPEND open "${CMAKE_MATCH_1}")
  endif()
endforeach()
if(open)
  message(FATAL_ERROR "eval.html: never closed: ${open}")
endif()
foreach(part IN ITEMS "<svg" "data:image/jpeg;base64," "moving F1" "prefers-color-scheme: dark")
  string(REPLACE ";" " " part "${part}")
  string(FIND "${html}" "${part}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "eval.html has no '${part}'")
  endif()
endforeach()
