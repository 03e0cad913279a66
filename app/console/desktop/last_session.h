// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sources/source_request.h"
#include "widgets/chrome/recent_name.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace teleta::console {

/// What was open when the console was closed, to be opened again: scenes, recordings, source lists, the
/// camera, arms and the study, each as "kind:path".
namespace last_session {

/// A source that is open.
struct OpenSource {
    app::SourceRequest request;
    QString list = {}; ///< source list that it was opened from; empty: none
};

/// The entries of what is open, each once, in its order; of a source list the list alone. study: its folder;
/// empty: none is open. Thread: any (pure).
[[nodiscard]] QStringList entriesOf(const std::vector<OpenSource>& open, const QString& study = {});

/// One entry, ready to be opened.
struct Entry {
    enum class Kind { scene, recording, list, camera, arm, site, study };
    Kind kind = Kind::scene;
    QString path; ///< of a scene that comes with the program, ":/scenes/NAME.toml"; empty of a camera
};
/// The entries that can be opened; unknown words, and what is gone, are left out. Reads no file, but
/// looks whether it is there. Thread: any.
[[nodiscard]] std::vector<Entry> entriesFrom(const QStringList& stored);

/// What people read of them, with commas: what is in a recording, as far as it is known, and the names of
/// files. Thread: any.
[[nodiscard]] QString text(const std::vector<Entry>& entries, const chrome::RecentNames& known);

} // namespace last_session

} // namespace teleta::console
