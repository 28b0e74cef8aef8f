#include "ui/document/recovery.h"

#include "ui/document/text.h"

#include "core/system/file.h"
#include "core/preset/preset_file.h"

#include <QFile>
#include <QFileInfo>

namespace fumage::ui {

namespace {

/// Soon enough that a crash costs no work worth speaking of, late enough that a drag does not write a hundred files.
constexpr int kSoonMs = 1000;

const QString kOrigin = QStringLiteral(".origin"); ///< beside a copy: the path of the document's file
const QString kMark = QStringLiteral(".mark"); ///< beside a copy: the mark of that file, when the work began
const QString kTrial =
    QStringLiteral(".trial"); ///< beside a copy: has a byte for each program that was about to show it
constexpr qint64 kMaxTrials = 2; ///< the first may have been ended by chance

std::optional<std::string> readBeside(const QString& copy, const QString& ending)
{
    constexpr std::size_t kLongestPath = 4096;
    const Result<std::string> text = readFile(toPath(copy + ending), kLongestPath);
    return text ? std::optional(text.value()) : std::nullopt;
}

QString readOrigin(const QString& copy)
{
    return toQString(readBeside(copy, kOrigin).value_or(std::string()));
}

std::optional<FileMark> readMark(const QString& copy)
{
    const std::optional<std::string> mark = readBeside(copy, kMark);
    return mark ? std::optional(FileMark::fromStdString(*mark)) : std::nullopt;
}

/// What lies beside the copy first: where the copy is, all of it is there.
Status writeCopy(const QString& path, const QString& originalPath, const FileMark& mark, const Preset& preset)
{
    if (Status origin = writeFileAtomically(toPath(path + kOrigin), originalPath.toStdString(), FileAccess::Private);
        !origin) {
        return origin;
    }
    if (Status marked = writeFileAtomically(toPath(path + kMark), mark.toStdString(), FileAccess::Private); !marked) {
        return marked;
    }
    return writeFileAtomically(toPath(path), formatPreset(preset), FileAccess::Private);
}

/// Takes a copy and what lies beside it away.
void removeCopy(const QString& path)
{
    for (const QString& file : {path, path + kOrigin, path + kMark, path + kTrial}) {
        QFile::remove(file);
    }
}

} // namespace

Recovery::Recovery(Document& document, const QDir& folder, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_copy(makeOwnFile(folder))
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(kSoonMs);
    connect(&m_soon, &QTimer::timeout, this, &Recovery::saveUnlessKept);
    connect(&document, &Document::effectChanged, this, &Recovery::follow);
    connect(&document, &Document::titleChanged, this, [this] {
        m_kept.reset(); // the copy tells of the file, too
        follow();
    });
}

Recovery::~Recovery()
{
    if (!m_isLeft) {
        discard();
    }
}

void Recovery::follow()
{
    if (m_isLeft) {
        return;
    }
    // Where keys are played there is a change at each frame: none may put the copy off, or takes it away again.
    if (!m_document.isModified()) {
        if (!m_isNothing) {
            discard();
        }
    } else if (!m_soon.isActive()) {
        m_isNothing = false;
        m_soon.start();
    }
}

void Recovery::saveUnlessKept()
{
    if (!m_kept || !(*m_kept == m_document.scene())) {
        save();
    }
}

void Recovery::save()
{
    m_soon.stop();
    if (!m_document.isModified()) {
        return;
    }
    m_isNothing = false;
    m_kept = m_document.scene();
    m_writing.ask(
        [this, write = writer()](const AsyncRequest::Report& report, const std::stop_token& stop) {
            const std::lock_guard lock(m_files);
            if (!stop.stop_requested()) {
                report([this, copy = write()] { note(copy); });
            }
        },
        [this](const Error& why) { note(why); });
}

std::function<Status()> Recovery::writer() const
{
    return [path = m_copy.path, origin = m_document.filePath(), mark = m_document.fileMark(),
               preset = m_document.preset()] { return writeCopy(path, origin, mark, preset); };
}

void Recovery::keep()
{
    m_soon.stop();
    m_writing.forget();
    const std::lock_guard lock(m_files);
    if (!m_isLeft && m_document.isModified()) {
        m_isNothing = false;
        note(writer()());
    }
}

void Recovery::leave()
{
    keep();
    m_isLeft = m_document.isModified();
}

void Recovery::note(const Status& copy)
{
    if (copy) {
        emit written();
    } else if (!m_hasFailed) {
        emit failed(translated(copy.error()));
    }
    m_hasFailed = !copy;
    if (!copy) {
        m_kept.reset();
    }
}

void Recovery::discard()
{
    m_soon.stop();
    m_kept.reset();
    m_writing.forget();
    const std::lock_guard lock(m_files); // what is being written must not come after its end
    removeCopy(m_copy.path);
    m_isNothing = true;
}

Recovery::Leftovers Recovery::find(const QDir& folder)
{
    Leftovers found;
    for (OwnFile& copy : takeOrphans(folder)) {
        Result<PresetReading> reading = readPresetFile(toPath(copy.path));
        if (!reading) {
            found.unreadable += copy.path;
        } else if (QFileInfo(copy.path + kTrial).size() >= kMaxTrials) {
            found.dangerous += copy.path;
        } else {
            found.works.push_back(
                {std::move(reading).value().preset, readOrigin(copy.path), readMark(copy.path), std::move(copy)});
        }
    }
    return found;
}

void Recovery::adopt(Work work)
{
    discard();
    m_copy = std::move(work.copy);
    m_isNothing = false;
    m_onTrial = true;
    // If it is this work that ends the program, others are not to run into it again and again.
    const std::string trials(static_cast<std::size_t>(QFileInfo(m_copy.path + kTrial).size()) + 1, '+');
    if (const Status trial = writeFileAtomically(toPath(m_copy.path + kTrial), trials, FileAccess::Private); !trial) {
        emit failed(translated(trial.error()));
    }
    m_document.loadUnsaved(work.preset, work.originalPath, work.originalMark);
}

void Recovery::markRecovered()
{
    if (m_onTrial) {
        m_onTrial = false;
        QFile::remove(m_copy.path + kTrial);
    }
}

} // namespace fumage::ui
