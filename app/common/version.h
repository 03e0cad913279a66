// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace teleta::app {

/// Which source this program was built from.
struct Version {
    QString number; ///< "0.2.0"
    QString
        commit; ///< first twelve digits of the commit; empty: not known, as for a source without its history
    bool modified = false; ///< the source had changes that no commit has

    /// What recordings and exports carry, a version with build metadata as in Semantic Versioning:
    /// "0.2.0+2bbb4fc8ab12", "0.2.0+2bbb4fc8ab12.modified", "0.2.0".
    [[nodiscard]] QString text() const;
};

/// Thread: any.
[[nodiscard]] const Version& version();

/// {"name": .., "version": .., "commit": .. or null, "modified": ..} as JSON with a line end. Thread: any.
[[nodiscard]] QString versionJson(const QString& program);

/// The program as an entry of BibTeX, with the data of CITATION.cff. Thread: any.
[[nodiscard]] QString citation();

} // namespace teleta::app
