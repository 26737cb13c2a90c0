// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace network {

/// What becomes of the instances of a class.
enum class Role {
  Moves,    ///< may move as a rigid body: the tracker finds out
  Dynamic,  ///< people and animals, which are not rigid: Instance::always_dynamic
  Ignored,  ///< cannot move: background
};

struct Class {
  std::string name;
  Role role = Role::Moves;
};

/// The 80 classes of COCO in the order in which YOLO and Detectron2 number them, from 0.
const std::vector<Class>& coco_classes();

/// The same by COCO's category numbers less 1, as torchvision has them: its label 1 is the first. 90 entries, those
/// that COCO does not use are ignored.
const std::vector<Class>& coco_categories();

/// A class a line, in the network's order: `name` or `name, role`, with the role `moves` (default), `dynamic` or
/// `ignored`.
/// @throws runner::FileError naming the line that is wrong.
std::vector<Class> read_classes(const std::filesystem::path& path);

/// Gives the classes of these names the role Dynamic.
/// @throws runner::UsageError naming one that is not among them.
void set_dynamic(std::vector<Class>& classes, const std::vector<std::string>& names);

}  // namespace network
