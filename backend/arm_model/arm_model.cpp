// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/arm_model.h"

#include <algorithm>

namespace teleta::arm_model {

namespace {

template <typename Named>
std::optional<std::size_t> indexOf(const std::vector<Named>& all, std::string_view name) {
    const auto found = std::ranges::find(all, name, &Named::name);
    if (found == all.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - all.begin());
}

} // namespace

std::optional<std::size_t> ArmModel::findLink(std::string_view linkName) const {
    return indexOf(links, linkName);
}

std::optional<std::size_t> ArmModel::findJoint(std::string_view jointName) const {
    return indexOf(joints, jointName);
}

std::vector<std::size_t> ArmModel::leaves() const {
    std::vector<bool> isParent(links.size(), false);
    for (const ModelJoint& joint : joints)
        isParent[joint.parentLink] = true;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (!isParent[i])
            found.push_back(i);
    }
    return found;
}

Eigen::Isometry3d jointMotion(const ModelJoint& joint, double q) {
    switch (joint.type) {
    case JointType::revolute:
    case JointType::continuous:
        return Eigen::Isometry3d(Eigen::AngleAxisd(q, joint.axis));
    case JointType::prismatic:
        return Eigen::Isometry3d(Eigen::Translation3d(q * joint.axis));
    case JointType::fixed:
        break;
    }
    return Eigen::Isometry3d::Identity();
}

} // namespace teleta::arm_model
