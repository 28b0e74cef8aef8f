// Names, paths and messages come from files that may hold anything: none of them is taken for HTML.
#include "editor_helpers.h"
#include "library_helpers.h"

#include "ui/export/export_queue.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/message_box.h"
#include "ui/widgets/plain_text.h"
#include "ui/presets/preset_list.h"
#include "ui/presets/start_dialog.h"
#include "ui/shell/main_window.h"
#include "ui/shell/session.h"

#include "core/system/file.h"
#include "core/effect/known_parameter.h"
#include "core/preset/preset_file.h"

#include <QComboBox>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QTextEdit>
#include <QTimer>

#include <sys/stat.h>

using namespace fumage;
using namespace fumage::tests;

namespace {

const QString kHostile = u"<img src='file:/etc/hostname'><h1>big</h1>"_q;
/// Folders that an archive may have, and a file in the last.
const QString kHostileFile = u"<b>x<img src='/dev/zero'>/<h1>big&Exit\ttab</h1>.json"_q;

/// Whether Qt would show a text that holds a hostile one as HTML.
bool isTaken(const QString& text)
{
    return (text.contains(u"<img"_q) || text.contains(u"<h1>"_q)) && Qt::mightBeRichText(text);
}

/// All that Qt may take for HTML in what is there now, as "where: text"; it finds windows, views and models by itself.
class Taken {
public:
    Taken()
    {
        for (const QWidget* widget : QApplication::allWidgets()) {
            lookAt(*widget);
        }
    }
    [[nodiscard]] const QStringList& found() const { return m_found; }
    [[nodiscard]] int hostile() const
    {
        return m_hostile;
    } ///< texts that came by: nothing is proven where there was none

private:
    void note(const QObject& where, const char* what, const QString& text)
    {
        m_hostile += text.contains(u"<img"_q) || text.contains(u"&lt;img"_q) ? 1 : 0;
        if (isTaken(text)) {
            m_found +=
                QStringLiteral("%1 %2 %3: %4")
                    .arg(QLatin1String(where.metaObject()->className()), where.objectName(), QLatin1String(what), text);
        }
    }
    void lookAt(const QWidget& widget)
    {
        note(widget, "tool tip", widget.toolTip());
        note(widget, "status tip", widget.statusTip());
        note(widget, "what is this", widget.whatsThis());
        if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
            const bool isPlain = label->textFormat() == Qt::PlainText;
            note(widget, "label", isPlain ? label->text().toHtmlEscaped() : label->text());
        }
        for (const QAction* action : widget.actions()) {
            note(widget, "tool tip of an action", action->toolTip());
            note(widget, "status tip of an action", action->statusTip());
        }
        if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget);
            view != nullptr && view->model() != nullptr) {
            lookAt(widget, *view->model(), view->rootIndex());
        }
        if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
            lookAt(widget, *box->model(), {});
        }
        if (const auto* text = qobject_cast<const QTextEdit*>(&widget)) {
            QVERIFY2(!text->toPlainText().contains(u"big"_q), qPrintable(text->objectName()));
        }
    }
    void lookAt(const QWidget& view, const QAbstractItemModel& model, const QModelIndex& parent)
    {
        for (int row = 0; row < model.rowCount(parent); ++row) {
            for (int column = 0; column < model.columnCount(parent); ++column) {
                const QModelIndex index = model.index(row, column, parent);
                for (const Qt::ItemDataRole role : {Qt::ToolTipRole, Qt::StatusTipRole, Qt::WhatsThisRole}) {
                    note(view, "item", index.data(role).toString());
                }
                lookAt(view, model, index);
            }
        }
    }

    QStringList m_found;
    int m_hostile = 0;
};

#define VERIFY_NOTHING_TAKEN()                                                                                         \
    do {                                                                                                               \
        const Taken taken;                                                                                             \
        QVERIFY(taken.hostile() > 0);                                                                                  \
        QVERIFY2(taken.found().isEmpty(), qPrintable(taken.found().join(QLatin1Char('\n'))));                          \
    } while (false)

ExportJob hostileJob()
{
    ExportJob job;
    job.name = kHostile.toStdString();
    job.preset.name = job.name;
    job.plan.kind = ExportKind::Picture;
    job.plan.output = toPath(u"/proc/"_q + kHostileFile + u".png"_q);
    return job;
}

} // namespace

class ForeignTextTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const QString library = toQString(userPresetFolder().string());
        QVERIFY(QDir().mkpath(library));
        Preset preset;
        preset.name = kHostile.toStdString();
        preset.description = kHostile.toStdString();
        QVERIFY(writePresetFile((library + u"/named.json"_q).toStdString(), preset).ok());
        preset.name = std::string(100000, 'x');
        preset.description = preset.name;
        QVERIFY(writePresetFile((library + u"/long.json"_q).toStdString(), preset).ok());
        QVERIFY(
            writeFileAtomically((library + u"/<img src=x>.json"_q).toStdString(), std::string_view("{ broken")).ok());
        QCOMPARE(mkfifo((library + u"/fifo.json"_q).toLocal8Bit().constData(), 0600), 0);
        QVERIFY(QFile::link(library + u"/circle.json"_q, library + u"/circle.json"_q));
        QVERIFY(QDir().mkpath(library + u"/folder.json"_q));
    }

    void messageBoxesShowPlainText()
    {
        MessageBox box(u"box"_q, MessageBox::Warning, kHostile, kHostile, MessageBox::Ok, nullptr);
        box.explain(kHostile);
        box.show();
        int seen = 0;
        for (const QLabel* label : box.findChildren<QLabel*>()) {
            seen += label->text() == kHostile ? 1 : 0;
            QVERIFY(label->pixmap().isNull() || label->text().isEmpty());
            QVERIFY(label->text().isEmpty() || label->textFormat() == Qt::PlainText);
        }
        QCOMPARE(seen, 2);
    }

    void toolTipsShowPlainText()
    {
        QCOMPARE(plainToolTip(u"a < b"_q), u"a < b"_q);
        QVERIFY(!plainToolTip(kHostile).contains(u"<img"_q));
        QVERIFY(plainToolTip(kHostile).contains(u"&lt;img"_q));
    }

    void theLibraryIsReadWhileTheListIsAlreadyThere()
    {
        PresetList list(64);
        list.reload();
        QCOMPARE(list.count(), 0); // nothing was waited for
        QTRY_COMPARE(list.count(), sizeOfLibrary());
        for (int i = 0; i < list.count(); ++i) {
            const QListWidgetItem* item = list.item(i);
            QVERIFY2(!item->toolTip().contains(u"<img"_q), qPrintable(item->toolTip()));
            QVERIFY(item->text().size() < 200 && item->toolTip().size() < 1000);
        }
        const auto broken = list.findItems(u"(broken)"_q, Qt::MatchContains);
        QCOMPARE(broken.size(), 4);
    }

    void readingAgainReplacesWhatWasRead()
    {
        PresetList list(64);
        list.reload();
        QTRY_COMPARE(list.count(), sizeOfLibrary());
        const int count = list.count();
        list.filter(u"chimney"_q, false);
        list.reload();
        list.reload();
        QSignalSpy filled(list.model(), &QAbstractItemModel::rowsInserted);
        QTRY_VERIFY(filled.size() >= count);
        QTRY_COMPARE(list.count(), count);
        int shown = 0;
        for (int i = 0; i < count; ++i) {
            shown += list.item(i)->isHidden() ? 0 : 1;
        }
        QVERIFY(shown >= 1 && shown < 5); // what was searched for is still searched for
    }

    void noWindowTakesForeignTextForHtml()
    {
        Session session;
        session.settings().addRecentFile(u"/tmp/<img src=x>.json"_q);
        MainWindow* window = session.openWindow();
        Preset preset;
        preset.name = kHostile.toStdString();
        preset.description = preset.name;
        window->document().load(preset, u"/tmp/<img src=x>.json"_q, true);
        window->notify(kHostile);
        window->actions().get("file.export").trigger();
        StartDialog start({u"/tmp/<img src=x>.json"_q}, window);
        QTRY_VERIFY(start.findChild<PresetList*>() != nullptr);
        start.show();
        QTRY_COMPARE(start.findChild<PresetList*>()->count(), sizeOfLibrary()); // the library has hostile names, too
        VERIFY_NOTHING_TAKEN();
        window->document().undoStack()->setClean();
        window->document().load(Preset(), {});
    }

    void theExportsOfForeignFoldersAreShownAsTheyAre()
    {
        Session session;
        MainWindow* window = session.openWindow();
        window->docks().showQueue();
        const Result<quint64> id = session.exports().add(hostileJob());
        QVERIFY(id.ok());
        QTRY_COMPARE(session.exports().find(id.value())->state, ExportState::Failed);
        const QModelIndex row = session.exports().index(0);
        QVERIFY(row.data(Qt::ToolTipRole).toString().contains(u"&lt;img"_q)); // escaped, and not left out
        VERIFY_NOTHING_TAKEN();
    }

    void messagesAndQuestionsOfForeignFilesAreShownAsTheyAre()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(kHostileFile);
        QVERIFY(QDir().mkpath(QFileInfo(path).path()));
        QVERIFY(writePresetFile(toPath(path), Preset()).ok());
        Session session([](QWidget*, const FileQuestion&) { return QString(); }, askInBox);
        MainWindow* window = session.openWindow();
        QVERIFY(window->files().openFile(path));
        QVERIFY(QFile::remove(path));
        window->notices().look();
        QVERIFY(window->messages().says(u"notice.onDisk"_q));
        VERIFY_NOTHING_TAKEN();
        Preset other;
        other.scene.layers[0].motion.gravity = 2.0F;
        QVERIFY(writePresetFile(toPath(path), other).ok());
        window->notices().look();
        window->document().edit(knownParameter("motion.gravity"), 3.0F);
        int boxes = 0;
        QTimer answer;
        connect(&answer, &QTimer::timeout, &answer, [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                ++boxes;
                VERIFY_NOTHING_TAKEN();
                box->reject();
            }
        });
        answer.start(10);
        QVERIFY(!window->files().save()); // asks about the file that has changed
        QVERIFY(!window->files().openFile(path + u"x"_q)); // cannot be opened
        QVERIFY(!window->files().confirmDiscard());
        QCOMPARE(boxes, 3);
        window->document().load(Preset(), {});
    }

    void boxesOfQtShowPlainText()
    {
        const Session session; // sees to it
        QMessageBox box;
        box.setText(kHostile);
        box.setInformativeText(kHostile);
        box.show();
        QInputDialog input;
        input.setLabelText(kHostile);
        input.show();
        VERIFY_NOTHING_TAKEN();
    }

    void menusMakeNoLettersAndShortcutsOfNames()
    {
        Session session;
        session.settings().addRecentFile(u"/tmp/R&D\tExit.json"_q);
        MainWindow* window = session.openWindow();
        const QString recent = window->actions().submenu("file.recent").actions().constFirst()->text();
        QVERIFY2(recent == u"R&&D Exit.json"_q, qPrintable(recent));
        Effect other;
        other.motion.gravity = 2.0F;
        window->document().replaceEffect(other, u"R&D\tCtrl+Q"_q);
        QVERIFY(window->actions().get("edit.undo").text().contains(u"R&&D Ctrl+Q"_q));
        window->document().load(Preset(), {});
    }

    void answersMakeNoLettersOfNames()
    {
        QString shown;
        QTimer::singleShot(0, qApp, [&shown] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            QVERIFY(box != nullptr);
            shown = box->buttons().constFirst()->text();
            box->buttons().constFirst()->click();
        });
        const ChoiceQuestion question{
            .name = u"box"_q, .title = u"Export"_q, .text = u"It exists."_q, .answers = {u"Save as a&b-2.png"_q}};
        QCOMPARE(askInBox(nullptr, question), 0);
        QCOMPARE(shown, u"Save as a&&b-2.png"_q);
    }

    void titlesHoldNothingThatSteers()
    {
        Session session;
        MainWindow* window = session.openWindow();
        const QString name = u"a\u001b]0;x\u0007[*]\u202eb\nc\u0085"_q;
        Preset preset;
        preset.name = name.toStdString();
        for (const QString& path : {QString(), u"/tmp/"_q + name + u".json"_q}) {
            window->document().load(preset, path);
            const QString title = window->windowTitle();
            for (const QChar& c : title) {
                QVERIFY2(
                    c.category() != QChar::Other_Control && c.category() != QChar::Other_Format, qPrintable(title));
            }
            QVERIFY2(title.contains(u"x?[*][*]?b c"_q), qPrintable(title)); // the mark of changes is Fumage's own
        }
    }
};

FUMAGE_TEST_MAIN(ForeignTextTest)
#include "foreign_text_test.moc"
