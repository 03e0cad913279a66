// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/remote_site_file.h"

#include "backend/core/beside_file.h"
#include "devices/site/site_topics.h"

#include <QCoreApplication>

namespace teleta::site_link {

namespace {

struct RemoteSiteFileText {
    Q_DECLARE_TR_FUNCTIONS(RemoteSiteFileText)
};

core::Expected<RemoteSiteFile> read(const core::TomlDocument& document, const std::string& path) {
    RemoteSiteFile file;
    core::TomlTable root = document.root();
    (void)root.choice("kind", {"remote_site"});
    file.name = readSiteName(root, "name");
    file.console = readSiteName(root, "console");
    file.person = root.text("person", std::string());
    file.viewer = root.boolean("viewer", false);
    if (root.has("mesh_path"))
        file.meshPath = core::besideFile(path, root.text("mesh_path"));
    file.meeting = readOperatorDomain(root, path);
    root.finish();
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    return file;
}

} // namespace

std::string readSiteName(core::TomlTable& table, std::string_view key) {
    std::string name = table.text(key);
    if (!name.empty() && !isSiteName(name))
        table.fail(
            key,
            RemoteSiteFileText::tr("\"%1\" cannot be a name").arg(QString::fromStdString(name)).toStdString(),
            RemoteSiteFileText::tr("a small letter, then at most 30 small letters, digits and _")
                .toStdString());
    return name;
}

core::Expected<RemoteSiteFile> readRemoteSite(const std::string& path) {
    TELETA_TRY(const core::TomlDocument document, core::TomlDocument::open(path));
    return read(document, path);
}

core::Expected<RemoteSiteFile> parseRemoteSite(std::string_view text, const std::string& file) {
    TELETA_TRY(const core::TomlDocument document, core::TomlDocument::parse(text, file));
    return read(document, file);
}

} // namespace teleta::site_link
