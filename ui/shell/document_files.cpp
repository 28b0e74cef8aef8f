#include "ui/shell/document_files.h"

#include "ui/document/text.h"
#include "ui/widgets/message_box.h"

#include "core/preset/library.h"
#include "core/preset/preset_file.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QInputDialog>
#include <QPushButton>

namespace fumage::ui {

namespace {

const QString kEnding = QStringLiteral("json");

QString presetFilter()
{
    return DocumentFiles::tr("Presets (*.json)") + QStringLiteral(";;") + DocumentFiles::tr("All files (*)");
}

QString openFilter()
{
    return DocumentFiles::tr("Presets, and pictures that carry one (*.json *.png *.exr)") + QStringLiteral(";;")
        + presetFilter();
}

/// Takes over what is being typed into a field: it is meant to be saved too.
void finishTyping()
{
    if (QWidget* typing = QApplication::focusWidget()) {
        typing->clearFocus();
        typing->setFocus();
    }
}

QString libraryFolder()
{
    return fromPath(userPresetFolder());
}

/// The file of a preset of a name.
QString presetFile(const QString& folder, const QString& name)
{
    return QDir(folder).filePath(QStringLiteral("%1.%2").arg(fileNameOf(name), kEnding));
}

} // namespace

DocumentFiles::DocumentFiles(
    Document& document, Settings& settings, const AskForFile& ask, const AskForChoice& askForChoice, QWidget* window)
    : QObject(window)
    , m_document(document)
    , m_settings(settings)
    , m_ask(ask)
    , m_askForChoice(askForChoice)
    , m_window(window)
{
}

void DocumentFiles::report(const QString& title, const Error& error) const
{
    MessageBox box(
        QStringLiteral("errorBox"), MessageBox::Warning, title, translated(error.message), MessageBox::Ok, m_window);
    QStringList more;
    if (!error.place.empty()) {
        more += translated(error.place);
    }
    if (!error.remedy.empty()) {
        more += translated(error.remedy) + QLatin1Char('.');
    }
    box.explain(more.join(QLatin1Char('\n')));
    box.exec();
}

void DocumentFiles::showWarnings(const QString& name, const std::vector<Message>& warnings) const
{
    if (warnings.empty()) {
        return;
    }
    MessageBox box(QStringLiteral("warningBox"), MessageBox::Information, tr("Opened with changes"),
        tr("“%1” was opened, but some of it had to be put right.").arg(name), MessageBox::Ok, m_window);
    QStringList lines;
    for (const Message& warning : warnings) {
        lines += translated(warning);
    }
    constexpr int kShown = 6;
    box.explain(QStringList(lines.mid(0, kShown)).join(QLatin1Char('\n')));
    if (lines.size() > kShown) {
        box.setDetailedText(lines.join(QLatin1Char('\n')));
    }
    box.exec();
}

bool DocumentFiles::confirmDiscard()
{
    finishTyping();
    if (!m_document.isModified()) {
        return true;
    }
    MessageBox box(QStringLiteral("unsavedBox"), MessageBox::Question, tr("Unsaved changes"),
        tr("Save the changes to “%1”?").arg(m_document.displayName()),
        MessageBox::Save | MessageBox::Discard | MessageBox::Cancel, m_window);
    box.explain(tr("Your changes will be lost if you don't save them."));
    box.setDefaultButton(MessageBox::Save);
    switch (box.exec()) {
    case MessageBox::Save: return save();
    case MessageBox::Discard: return true;
    default: return false;
    }
}

void DocumentFiles::newDocument()
{
    if (confirmDiscard()) {
        m_document.load(newPreset(), {});
    }
}

void DocumentFiles::open()
{
    const QString folder =
        m_document.filePath().isEmpty() ? m_settings.lastFolder() : QFileInfo(m_document.filePath()).path();
    const QString path = m_ask(m_window,
        {.purpose = FileQuestion::Purpose::Open,
            .title = tr("Open"),
            .start = folder,
            .filter = openFilter(),
            .ending = kEnding});
    if (!path.isEmpty()) {
        m_settings.setLastFolder(QFileInfo(path).absolutePath());
        openFile(path);
    }
}

bool DocumentFiles::openFile(const QString& name)
{
    const QString path = QFileInfo(name).absoluteFilePath();
    // Others may write it while people are asked below: then it has changed since it was read.
    FileMark mark = markOfFile(path);
    // Read first: a broken file must not cost the document that is open.
    Result<PresetReading> reading = readPresetFile(toPath(path));
    if (!reading) {
        if (reading.error().code == ErrorCode::FileNotFound) {
            m_settings.removeRecentFile(path);
        }
        report(tr("Cannot open “%1”").arg(QFileInfo(path).fileName()), reading.error());
        return false;
    }
    if (!confirmDiscard()) {
        return false;
    }
    // What was to be saved first may have been saved to this very file.
    if (m_document.fileMark() != mark && m_document.fileMark() == markOfFile(path)) {
        mark = m_document.fileMark();
        reading = readPresetFile(toPath(path));
        if (!reading) {
            report(tr("Cannot open “%1”").arg(QFileInfo(path).fileName()), reading.error());
            return false;
        }
    }
    const std::optional<int> frame = reading.value().frame;
    // A picture is no place to save a preset to.
    m_document.load(reading.value().preset, frame ? QString() : path, false, frame ? FileMark() : mark);
    if (frame) {
        emit pictureOpened(*frame);
    }
    m_settings.addRecentFile(path);
    showWarnings(QFileInfo(path).fileName(), reading.value().warnings);
    return true;
}

bool DocumentFiles::openPreset(const Preset& preset)
{
    if (!confirmDiscard()) {
        return false;
    }
    m_document.load(preset, {});
    return true;
}

void DocumentFiles::openEntry(const LibraryEntry& entry)
{
    if (const Result<PresetReading> reading = loadPreset(entry)) {
        openPreset(reading.value().preset);
    } else {
        report(tr("Cannot open “%1”").arg(toQString(entry.id)), reading.error());
    }
}

bool DocumentFiles::saveTo(const QString& path)
{
    finishTyping();
    if (const Status status = m_document.save(path); !status) {
        report(tr("Cannot save “%1”").arg(QFileInfo(path).fileName()), status.error());
        return false;
    }
    m_settings.addRecentFile(path);
    if (QFileInfo(path).absolutePath() == QDir(libraryFolder()).absolutePath()) {
        emit libraryChanged();
    }
    return true;
}

bool DocumentFiles::save()
{
    if (m_document.filePath().isEmpty()) {
        return saveAs();
    }
    return m_document.compareWithDisk() == DiskState::Changed ? saveOverChanges() : saveTo(m_document.filePath());
}

bool DocumentFiles::saveOverChanges()
{
    const int answer = m_askForChoice(m_window,
        {.name = QStringLiteral("changedOnDiskBox"),
            .title = tr("Changed by another program"),
            .text = tr("“%1” has been changed by another program since it was opened or saved here. If you overwrite "
                       "it, those changes are lost.")
                        .arg(QFileInfo(m_document.filePath()).fileName()),
            .answers = {tr("Save as…"), tr("Overwrite"), tr("Cancel")}});
    constexpr int kSaveAs = 0;
    constexpr int kOverwrite = 1;
    return answer == kSaveAs ? saveAs() : answer == kOverwrite && saveTo(m_document.filePath());
}

void DocumentFiles::reload()
{
    const QString file = QFileInfo(m_document.filePath()).fileName();
    const Result<PresetReading> reading = m_document.reload();
    if (reading) {
        showWarnings(file, reading.value().warnings);
    } else {
        report(tr("Cannot open “%1”").arg(file), reading.error());
    }
}

QString DocumentFiles::suggestedPath() const
{
    if (!m_document.filePath().isEmpty()) {
        return m_document.filePath();
    }
    return presetFile(m_settings.lastFolder(), m_document.displayName());
}

bool DocumentFiles::saveAs()
{
    const QString path = m_ask(m_window,
        {.purpose = FileQuestion::Purpose::Save,
            .title = tr("Save as"),
            .start = suggestedPath(),
            .filter = presetFilter(),
            .ending = kEnding});
    if (path.isEmpty()) {
        return false;
    }
    m_settings.setLastFolder(QFileInfo(path).absolutePath());
    return saveTo(path);
}

QString DocumentFiles::askForName() const
{
    QInputDialog dialog(m_window);
    dialog.setObjectName(QStringLiteral("libraryName"));
    dialog.setWindowTitle(tr("Save to the library"));
    dialog.setLabelText(tr("Name of the preset"));
    dialog.setTextValue(m_document.displayName());
    return dialog.exec() == QDialog::Accepted ? dialog.textValue().trimmed() : QString();
}

bool DocumentFiles::mayReplace(const QString& name) const
{
    MessageBox box(QStringLiteral("replaceBox"), MessageBox::Question, tr("Save to the library"),
        tr("There is a preset “%1” already. Replace it?").arg(name), MessageBox::Yes | MessageBox::No, m_window);
    box.setDefaultButton(MessageBox::No);
    return box.exec() == MessageBox::Yes;
}

void DocumentFiles::saveToLibrary()
{
    const QString name = askForName();
    if (name.isEmpty()) {
        return;
    }
    const QString path = presetFile(libraryFolder(), name);
    if (libraryFolder().isEmpty() || !QDir().mkpath(libraryFolder())) {
        report(tr("Cannot save “%1”").arg(name),
            {ErrorCode::PermissionDenied, makeMessage("the folder of your presets cannot be made"),
                libraryFolder().toStdString(), makeMessage("Save the preset somewhere else")});
        return;
    }
    if (!QFileInfo::exists(path) || mayReplace(name)) {
        saveTo(path);
    }
}

void DocumentFiles::revert()
{
    m_document.replaceScene(m_document.referenceScene(), 0, tr("Revert"));
}

void DocumentFiles::copyPreset() const
{
    QApplication::clipboard()->setText(toQString(formatPreset(m_document.preset())));
}

void DocumentFiles::pastePreset()
{
    const Result<PresetReading> reading = parsePreset(QApplication::clipboard()->text().toStdString(), "the clipboard");
    if (!reading) {
        report(tr("Cannot paste a preset"), reading.error());
        return;
    }
    m_document.replaceScene(reading.value().preset.scene, 0, tr("Paste a preset"));
    showWarnings(tr("The clipboard"), reading.value().warnings);
}

} // namespace fumage::ui
