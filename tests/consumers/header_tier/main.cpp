// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// A host that compiles all of dot's headers and the default pipeline itself, and follows a parked car and one that
// crosses.

#include <cstdio>

#include "all_headers.hpp"
#include "support/street.hpp"

int main() {
  dot::test::Film<> film = dot::test::street();
  dot::Dot<> tracker{dot::Pinhole(dot::test::small_camera())};
  const auto state = [&](const dot::Result& result, std::uint32_t body) {
    const dot::ObjectResult* object = dot::test::object_on(result, film.truth().ids, body);
    return object != nullptr ? object->state : dot::State::Background;
  };

  dot::State parked{}, mover{};
  for (int i = 0; i < 10; ++i) {
    const dot::Result& result = film.next(tracker);
    parked = state(result, dot::test::parked);
    mover = state(result, dot::test::mover);
  }
  std::printf("C++%d (%ld): the parked car is %s, the other %s\n", STANDARD, static_cast<long>(__cplusplus),
              dot::to_string(parked), dot::to_string(mover));
  return parked == dot::State::Static && mover == dot::State::Moving ? 0 : 1;
}
