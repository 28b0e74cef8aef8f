#include "ui/shell/file_notices.h"

#include "ui/document/text.h"
#include "ui/widgets/message_bar.h"
#include "ui/shell/document_files.h"

#include <QFileInfo>

namespace fumage::ui {

namespace {

const QString kOnDisk = QStringLiteral("notice.onDisk");
const QString kRecovered = QStringLiteral("notice.recovered");

} // namespace

FileNotices::FileNotices(Document& document, DocumentFiles& files, MessageBar& bar)
    : m_document(document)
    , m_files(files)
    , m_bar(bar)
    , m_watch(document)
{
    connect(&m_watch, &FileWatch::changed, this, &FileNotices::follow);
    connect(&document, &Document::loaded, this, &FileNotices::takeRecovered);
    connect(&document, &Document::titleChanged, this, [this] {
        if (!m_document.isModified()) {
            takeRecovered();
        }
    });
}

void FileNotices::follow(DiskState state)
{
    m_bar.take(kOnDisk);
    const QString file = onOneLine(QFileInfo(m_document.filePath()).fileName());
    if (state == DiskState::Changed) {
        m_bar.say(kOnDisk,
            tr("“%1” has been changed by another program. Reload it, which can be undone, or keep this version: it "
               "replaces the other when you save it.")
                .arg(file),
            {{tr("Reload"),
                 [this] {
                     m_files.reload();
                     if (const DiskState now = m_watch.look(); now != DiskState::Same) {
                         follow(now); // it could not be read: others may be about to write it
                     }
                 }},
                {tr("Keep this version"), [this] { m_document.keepOverDisk(); }}});
    } else if (state == DiskState::Gone) {
        m_bar.say(kOnDisk,
            tr("“%1” has been deleted or moved. What you see is kept as unsaved work: save it to have a file again.")
                .arg(file),
            {{tr("Save"), [this] { m_files.save(); }}, {tr("Save as…"), [this] { m_files.saveAs(); }},
                {tr("Close"), {}}});
    }
}

void FileNotices::sayRecovered()
{
    const auto unlessDone = [this](bool done) {
        if (!done) {
            sayRecovered();
        }
    };
    m_bar.say(kRecovered, tr("This is unsaved work from before the program ended unexpectedly. Save it to keep it."),
        {{tr("Save"), [this, unlessDone] { unlessDone(m_files.save()); }},
            {tr("Discard"), [this] { discardRecovered(); }}, {tr("Close"), {}}});
}

void FileNotices::takeRecovered()
{
    m_bar.take(kRecovered);
}

/// Of a document with a file it can be had back by Redo; any other is asked about.
void FileNotices::discardRecovered()
{
    if (m_document.filePath().isEmpty() || m_document.undoStack()->count() == 0) {
        m_files.newDocument();
        return;
    }
    m_document.undoStack()->setIndex(0);
    m_document.moveCamera(m_document.reference().camera);
}

} // namespace fumage::ui
