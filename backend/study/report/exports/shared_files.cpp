// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/exports/shared_files.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <filesystem>
#include <sys/stat.h>
#include <system_error>

namespace teleta::study {

namespace {

namespace fs = std::filesystem;

struct SharedText {
    Q_DECLARE_TR_FUNCTIONS(StudyExport)
};

fs::perms withoutUmask(fs::perms wanted) {
    const mode_t mask = ::umask(S_IRWXG | S_IRWXO);
    ::umask(mask);
    return wanted & ~static_cast<fs::perms>(mask);
}

core::Expected<void> allow(const fs::path& path, fs::perms wanted) {
    std::error_code failed;
    fs::permissions(path, withoutUmask(wanted), fs::perm_options::add, failed);
    if (failed)
        return core::failed(core::ErrorKind::ioFailed,
                            SharedText::tr("the file cannot be opened to others: %1")
                                .arg(QString::fromStdString(failed.message())),
                            {}, {path.string()});
    return {};
}

constexpr fs::perms kReadFile = fs::perms::group_read | fs::perms::others_read;
constexpr fs::perms kEnter = fs::perms::group_exec | fs::perms::others_exec;

core::Expected<void> share(const fs::path& path) {
    std::error_code ignored;
    if (!fs::is_directory(path, ignored))
        return allow(path, kReadFile);
    TELETA_CHECK(allow(path, kReadFile | kEnter));
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path, ignored)) {
        TELETA_CHECK(allow(entry.path(), entry.is_directory(ignored) ? kReadFile | kEnter : kReadFile));
    }
    return {};
}

} // namespace

const std::vector<std::string>& resultFiles() {
    static const std::vector<std::string> kNames{"report.html",
                                                 "confusion_long.csv",
                                                 "summary.csv",
                                                 "group.csv",
                                                 "anova.csv",
                                                 "comparisons.csv",
                                                 "ranks.csv",
                                                 "binomial_model.csv",
                                                 "response_times.csv",
                                                 "exclusions.csv",
                                                 "thresholds.csv",
                                                 "levels.csv",
                                                 "sdt.csv",
                                                 "figures"};
    return kNames;
}

core::Expected<void> shareFiles(const std::string& folder, const std::vector<std::string>& names) {
    // Through the folder, whose other files stay closed, one must be able to go.
    TELETA_CHECK(allow(folder, kEnter));
    std::error_code ignored;
    for (const std::string& name : names) {
        if (const fs::path path = fs::path(folder) / name; fs::exists(path, ignored))
            TELETA_CHECK(share(path));
    }
    return {};
}

} // namespace teleta::study
