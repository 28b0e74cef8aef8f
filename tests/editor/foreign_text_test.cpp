// Names, paths and messages come from files that may hold anything: none of them is taken for HTML.
#include "editor_helpers.h"

#include "ui/face/message_box.h"
#include "ui/face/plain_text.h"
#include "ui/presets/preset_list.h"
#include "ui/presets/start_dialog.h"
#include "ui/shell/main_window.h"

#include "core/base/file.h"

#include <QLabel>
#include <QMenu>

#include <sys/stat.h>

using namespace fumage;
using namespace fumage::tests;

namespace {

const QString kHostile = u"<img src='file:/etc/hostname'><h1>big</h1>"_q;

/// Whether Qt would show a text that holds the hostile one as HTML.
bool isTaken(const QString& text)
{
    return text.contains(u"<img"_q) && Qt::mightBeRichText(text);
}

void verifyLabels(const QWidget& window)
{
    for (const QLabel* label : window.findChildren<QLabel*>()) {
        QVERIFY2(label->textFormat() == Qt::PlainText || !isTaken(label->text()), qPrintable(label->objectName() + u": "_q + label->text()));
    }
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
        QVERIFY(writeFileAtomically((library + u"/<img src=x>.json"_q).toStdString(), std::string_view("{ broken")).ok());
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
        QTRY_VERIFY(list.count() > 12);
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
        QTRY_VERIFY(list.count() > 12);
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
        verifyLabels(*window);
        for (const QAction* action : window->findChildren<QAction*>()) {
            QVERIFY2(!isTaken(action->toolTip()), qPrintable(action->toolTip()));
        }
        for (const QListWidget* list : start.findChildren<QListWidget*>()) {
            for (int i = 0; i < list->count(); ++i) {
                QVERIFY2(!isTaken(list->item(i)->toolTip()), qPrintable(list->item(i)->toolTip()));
            }
        }
        window->document().undoStack()->setClean();
        window->document().load(Preset(), {});
    }
};

FUMAGE_TEST_MAIN(ForeignTextTest)
#include "foreign_text_test.moc"
