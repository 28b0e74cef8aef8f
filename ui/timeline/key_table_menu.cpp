#include "ui/timeline/key_table_menu.h"

#include "ui/document/key_edits.h"
#include "ui/document/parameter_text.h"
#include "ui/document/text.h"
#include "ui/widgets/message_box.h"

#include "core/scene/key_table.h"
#include "core/system/file.h"

#include <QCoreApplication>
#include <QMenu>

namespace fumage::ui {

namespace {

struct KeyTable {
    Q_DECLARE_TR_FUNCTIONS(KeyTable)
};

QString filter()
{
    return KeyTable::tr("Tables (*.csv *.tsv *.txt);;All files (*)");
}

void writeTable(const Document& document, const Parameter& parameter, const QString& path, QWidget* parent)
{
    const Track* track = document.track(parameter);
    const Status status = track != nullptr ? writeFileAtomically(toPath(path), formatKeyTable(*track)) : Status(Done{});
    if (!status) {
        MessageBox::warn(parent, KeyTable::tr("The key frames could not be written"), translated(status.error()));
    }
}

Result<Track> readTable(const Document& document, const Parameter& parameter, const QString& path)
{
    constexpr std::size_t kMaxBytes = 4U << 20U;
    const Result<std::string> text = readFile(toPath(path), kMaxBytes);
    return text ? parseKeyTable(parameter, text.value(), document.scene().timeline.frameRate)
                : Result<Track>(text.error());
}

} // namespace

void addKeyTable(QMenu& menu, Document& document, const Track& track, const AskForFile& askForFile, QWidget* parent)
{
    const Parameter& parameter = *track.parameter;
    menu.addAction(KeyTable::tr("Write as CSV…"), parent, [&document, &parameter, askForFile, parent] {
        const QString path = askForFile(parent,
            {FileQuestion::Purpose::Save, KeyTable::tr("Write key frames"), {}, filter(), false,
                QStringLiteral("csv")});
        if (!path.isEmpty()) {
            writeTable(document, parameter, path, parent);
        }
    });
    menu.addAction(KeyTable::tr("Read from CSV…"), parent,
            [&document, &parameter, askForFile, parent] {
                const QString path =
                    askForFile(parent, {FileQuestion::Purpose::Open, KeyTable::tr("Read key frames"), {}, filter()});
                if (path.isEmpty()) {
                    return;
                }
                const Result<Track> read = readTable(document, parameter, path);
                if (!read) {
                    MessageBox::warn(
                        parent, KeyTable::tr("The key frames could not be read"), translated(read.error()));
                    return;
                }
                Track table = read.value();
                if (const Track* before = document.track(parameter)) {
                    table.before = before->before;
                    table.after = before->after;
                }
                replaceTracks(document, {table}, KeyTable::tr("Read key frames of %1").arg(fullLabelOf(parameter)));
            })
        ->setEnabled(document.canEdit(parameter));
    menu.addSeparator();
}

} // namespace fumage::ui
