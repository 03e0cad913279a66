// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/files/pattern_folder.h"
#include "backend/playback/player_types.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace teleta::console {

/// The user's own patterns: reads and watches their folder on its own thread, and adds, renames and deletes
/// patterns there; renaming and deleting can be undone. Thread: GUI. Only the destructor blocks, while a file
/// is being read or written.
class PatternCollection : public QObject {
    Q_OBJECT

public:
    /// folder: empty: there are no own patterns and none can be saved.
    explicit PatternCollection(QString folder, QObject* parent = nullptr);
    ~PatternCollection() override;

    [[nodiscard]] const std::vector<pattern::StoredPattern>& patterns() const { return m_content->patterns; }
    /// The pattern of a file; null when it does not exist or is damaged.
    [[nodiscard]] std::shared_ptr<const pattern::Pattern> atPath(const QString& path) const;
    /// The own or built-in pattern with this id, ready to be played; without evaluate when there is none.
    [[nodiscard]] playback::Program program(const std::string& id) const;
    [[nodiscard]] bool isPossible() const { return !m_folder.path().empty(); }
    /// Whether the folder has been read at least once.
    [[nodiscard]] bool isRead() const { return m_isRead; }

    void refresh();
    /// Emits added() or failed() later.
    void add(const pattern::Pattern& pattern);
    void duplicate(const pattern::Pattern& pattern, const QString& name);
    void rename(const QString& path, const QString& name);
    void remove(const QString& path);
    /// Undoes the last deletion or renaming.
    void undo();
    [[nodiscard]] bool canUndo() const { return !m_done.empty(); }
    /// Text about the last deletion or renaming; empty when there is none.
    [[nodiscard]] QString lastDone() const;

signals:
    void changed();
    void added(const QString& path);
    void removed(const QString& path);
    void doneChanged();
    void failed(const QString& what, const teleta::core::Error& error);

private:
    struct Content {
        std::vector<pattern::StoredPattern> patterns;
        std::map<std::string, playback::Program, std::less<>> programs;
    };
    struct Done {
        QString path;
        QString name;    ///< before
        QString deleted; ///< new path of the file; empty: it was renamed
    };

    [[nodiscard]] QString nameOf(const QString& path) const;
    [[nodiscard]] static std::shared_ptr<const Content> contentOf(const pattern::PatternFolder& folder,
                                                                  const Content& before);
    void watch();
    void did(Done done);

    pattern::PatternFolder m_folder;
    QThreadPool m_pool; ///< one thread, so that requests are carried out in order
    QFileSystemWatcher m_watcher;
    QTimer m_rest;
    std::shared_ptr<const Content> m_content = std::make_shared<Content>();
    std::vector<Done> m_done;
    bool m_reading = false;
    bool m_again = false;
    bool m_isRead = false;
};

} // namespace teleta::console
