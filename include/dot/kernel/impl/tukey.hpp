// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace dot::kernel {

/// (1 - e^2 / (c^2 v))^3, 0 beyond c, of residuals e with the variances v, over V::W lanes. Tukey's cost is 1 minus
/// that, times the highest cost c^2 / 6. A residual that is no number has the highest cost.
template <typename V>
typename V::F tukey_kept(typename V::F e, typename V::F v, float c) {
  using F = typename V::F;
  const F share = V::mul(V::div(V::mul(e, e), v), V::set(1 / (c * c)));
  const F inside = V::max(V::sub(V::set(1), share), V::set(0));
  return V::mul(V::mul(inside, inside), inside);
}

}  // namespace dot::kernel
