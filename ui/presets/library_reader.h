#pragma once

#include "ui/concurrency/latest_only_worker.h"

#include "core/preset/library.h"

#include <QObject>
#include <QString>

#include <vector>

namespace fumage::ui {

/// A preset of the library as it was read.
struct LibraryPreset {
    LibraryEntry entry;
    Preset preset;
    QString trouble; ///< why it cannot be read; empty where it was
};

/// Reads the library on a thread of its own: a folder of the user's may hold anything, and the window is not to wait
/// for it.
class LibraryReader : public QObject {
    Q_OBJECT

public:
    explicit LibraryReader(QObject* parent = nullptr);

    /// Reads the user's presets and the built-in ones anew; what is being read is given up.
    void read();

signals:
    /// Some presets more, in the order of the library, on the thread of this object.
    /// @param first nothing that was found before counts any longer
    void found(const std::vector<fumage::ui::LibraryPreset>& presets, bool first);

private:
    void work(quint64 number, const std::stop_token& stop);
    void send(quint64 number, std::vector<LibraryPreset> presets, bool first);

    quint64 m_newest = 0;
    LatestOnlyWorker<quint64> m_job;
};

} // namespace fumage::ui
