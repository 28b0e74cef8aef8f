#pragma once

#include "editor_helpers.h"

#include "ui/export/file_conflict.h"
#include "ui/export/queue_panel.h"

#include <QAction>
#include <QListView>

#include <memory>

namespace fumage::tests {

inline constexpr int kEndMs = 60000;

/// Pictures of it take no time.
inline Preset tinyPreset()
{
    Preset preset;
    preset.scene.layers[0].emitter.count = 200;
    preset.scene.layers[0].noise.resolution = 16;
    preset.scene.layers[0].noise.slices = 2;
    preset.scene.light.resolution = 16;
    preset.scene.output.width = 24;
    preset.scene.output.height = 16;
    return preset;
}

/// The queue of exports in a folder of its own, and its panel, for each test.
class QueueFixture : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_queue = std::make_unique<ExportQueue>(queueFolder());
        m_panel =
            std::make_unique<QueuePanel>(*m_queue, [this](QWidget*, const FileQuestion&) { return m_chosenFile; });
        m_panel->resize(320, 400);
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
    }
    void cleanup()
    {
        m_panel.reset();
        m_queue.reset();
        m_folder.reset();
    }

protected:
    [[nodiscard]] QDir queueFolder() const { return QDir(m_folder->filePath(u"queue"_q)); }
    [[nodiscard]] std::string at(const std::string& name) const
    {
        return (m_folder->path() + u"/out/"_q).toStdString() + name;
    }
    [[nodiscard]] QStringList filesWritten() const
    {
        return QDir(m_folder->filePath(u"out"_q)).entryList({u"*.png"_q}, QDir::Files, QDir::Name);
    }
    [[nodiscard]] QFileInfoList listFiles() const { return queueFolder().entryInfoList({u"*.json"_q}, QDir::Files); }
    [[nodiscard]] ExportState stateOf(int row) const { return m_queue->at(row).state; }
    [[nodiscard]] QListView* list() const { return m_panel->findChild<QListView*>(u"queue.list"_q); }
    [[nodiscard]] QAction* action(const char* name) const { return m_panel->findChild<QAction*>(QLatin1String(name)); }
    void choose(int row) { list()->setCurrentIndex(m_queue->index(row)); }

    [[nodiscard]] static ExportJob jobFor(const std::string& name, const std::string& output)
    {
        ExportJob job{name, tinyPreset(), {}};
        job.plan.kind = ExportKind::Picture;
        job.plan.output = output;
        return job;
    }

    quint64 add(const char* name) { return m_queue->add(jobFor(name, at(std::string(name) + ".png"))).value(); }

    /// One that does not end by itself.
    void addLong()
    {
        ExportJob job = jobFor("long", at("long_######.png"));
        job.plan.kind = ExportKind::Sequence;
        job.plan.frames = {0, 20'000, 1};
        QVERIFY(m_queue->add(std::move(job)).ok());
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_chosenFile;
    std::unique_ptr<ExportQueue> m_queue;
    std::unique_ptr<QueuePanel> m_panel;
};

} // namespace fumage::tests
