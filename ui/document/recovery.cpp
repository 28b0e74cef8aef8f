#include "ui/document/recovery.h"

#include "ui/document/text.h"

#include "core/base/file.h"

#include <QCoreApplication>
#include <QFile>
#include <QUuid>

namespace fumage::ui {

namespace {

/// Soon enough that a crash costs no work worth speaking of, late enough that a drag does not write a hundred files.
constexpr int kSoonMs = 1000;

const QString kCopy = QStringLiteral(".json");
const QString kLock = QStringLiteral(".lock");
const QString kOrigin = QStringLiteral(".origin"); ///< beside a copy: the path of the document's file

} // namespace

Recovery::Recovery(Document& document, const QDir& folder, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_folder(folder)
{
    m_folder.mkpath(QStringLiteral("."));
    const QString name = m_folder.filePath(QUuid::createUuid().toString(QUuid::WithoutBraces));
    m_path = name + kCopy;
    m_lock = std::make_unique<QLockFile>(name + kLock);
    m_lock->setStaleLockTime(0);
    m_lock->tryLock(0);
    m_soon.setSingleShot(true);
    m_soon.setInterval(kSoonMs);
    connect(&m_soon, &QTimer::timeout, this, &Recovery::saveNow);
    connect(&document, &Document::effectChanged, this, &Recovery::follow);
    connect(&document, &Document::titleChanged, this, &Recovery::follow);
}

Recovery::~Recovery()
{
    discard();
}

void Recovery::follow()
{
    if (m_document.isModified()) {
        m_soon.start();
    } else {
        discard();
    }
}

void Recovery::saveNow()
{
    m_soon.stop();
    if (!m_document.isModified()) {
        return;
    }
    const Status origin = writeFileAtomically((m_path + kOrigin).toStdString(), m_document.filePath().toStdString());
    const Status copy = origin ? writePresetFile(m_path.toStdString(), m_document.preset()) : origin;
    if (!copy && !m_hasFailed) {
        emit failed(toQString(copy.error().text()));
    }
    m_hasFailed = !copy;
}

void Recovery::discard()
{
    m_soon.stop();
    QFile::remove(m_path);
    QFile::remove(m_path + kOrigin);
}

std::vector<Recovery::Found> Recovery::take(const QDir& folder)
{
    std::vector<Found> found;
    for (const QString& name : folder.entryList({QLatin1Char('*') + kCopy}, QDir::Files, QDir::Time)) {
        const QString path = folder.filePath(name);
        QLockFile lock(path.chopped(kCopy.size()) + kLock);
        // A lock whose program is gone can be had; that of a running one cannot.
        lock.setStaleLockTime(0);
        if (!lock.tryLock(0)) {
            continue;
        }
        Result<PresetReading> reading = readPresetFile(path.toStdString());
        if (!reading) {
            continue;
        }
        QFile origin(path + kOrigin);
        const bool hasOrigin = origin.open(QIODevice::ReadOnly);
        found.push_back({std::move(reading).value().preset, hasOrigin ? QString::fromUtf8(origin.readAll()) : QString()});
        origin.close();
        QFile::remove(path);
        QFile::remove(path + kOrigin);
    }
    return found;
}

} // namespace fumage::ui
