// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/sources/source_manager.h"
#include "widgets/base/controls/badge.h"

namespace teleta::console {

/// Where the data of a source come from; live: it is not open yet. Thread: GUI.
[[nodiscard]] base::Provenance provenanceOf(const SourceManager::Item& item);

} // namespace teleta::console
