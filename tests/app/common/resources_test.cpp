// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>

#include <gtest/gtest.h>

namespace {

const QString kResources = QStringLiteral(TELETA_SOURCE_DIR "/resources");

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
}

class ResourcesTest : public testing::TestWithParam<const char*> {};

TEST_P(ResourcesTest, embedsEveryFileOfTheFolder) {
    const QString folder = QString::fromLatin1(GetParam());
    const QStringList files = QDir(kResources + folder).entryList(QDir::Files, QDir::Name);
    ASSERT_FALSE(files.isEmpty());
    EXPECT_EQ(QDir(QLatin1Char(':') + folder).entryList(QDir::Files, QDir::Name), files)
        << "list the new file in resources/CMakeLists.txt";
    for (const QString& file : files) {
        const QString path = folder + QLatin1Char('/') + file;
        EXPECT_EQ(contentOf(QLatin1Char(':') + path), contentOf(kResources + path)) << path.toStdString();
    }
}

INSTANTIATE_TEST_SUITE_P(Folders, ResourcesTest, testing::Values("/scenes", "/icons"));

} // namespace
