// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// compare RESULT_A RESULT_B [tracker]: two hosts built with different flags must see the same. The compiled tier is the
// same code in both: equal to the last pixel. The templates were compiled by each host, or taken from the library where
// that is the same: same states, and label pixels that differ by no more than rounding at an outline. With "tracker"
// they are left out.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.empty()) throw std::runtime_error(path.string() + " is missing or empty");
  return bytes;
}

double equal_share(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return 0;
  std::size_t equal = 0;
  for (std::size_t i = 0; i < a.size(); ++i) equal += a[i] == b[i];
  return static_cast<double>(equal) / static_cast<double>(a.size());
}

int failures = 0;

void expect(bool holds, const std::string& what) {
  std::cout << (holds ? "ok      " : "FAILED  ") << what << '\n';
  failures += !holds;
}

}  // namespace

int main(int argc, char** argv) {
  const bool tracker_only = argc == 4 && std::string(argv[3]) == "tracker";
  if (argc != 3 && !tracker_only) {
    std::cerr << "usage: compare RESULT_A RESULT_B [tracker]\n";
    return 2;
  }
  try {
    const fs::path a = argv[1];
    const fs::path b = argv[2];
    const auto same = [&](const char* name) { return read(a / name) == read(b / name); };
    expect(same("tracker_labels.bin"), "Tracker: label images identical");
    expect(same("tracker_states.txt"), "Tracker: states identical");
    if (!tracker_only) {
      expect(same("dot_states.txt"), "Dot<>: states identical");
      const double share = equal_share(read(a / "dot_labels.bin"), read(b / "dot_labels.bin"));
      expect(share >= 0.999, "Dot<>: " + std::to_string(100 * share) + " % of the label pixels equal, at least 99.9");
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return failures == 0 ? 0 : 1;
}
