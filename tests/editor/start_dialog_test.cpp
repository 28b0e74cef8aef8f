// What an empty session shows first.
#include "editor_helpers.h"
#include "library_helpers.h"

#include "ui/presets/scene_card.h"
#include "ui/presets/start_dialog.h"

#include <QCheckBox>
#include <QProxyStyle>
#include <QPushButton>

using namespace fumage;
using namespace fumage::tests;

namespace {

const QStringList kRecent{QStringLiteral("/somewhere/old fire.json"), QStringLiteral("/elsewhere/steam.json")};

/// A dialog that is shown, with all that it has said.
struct Shown {
    StartDialog dialog{kRecent, nullptr};
    QSignalSpy presets{&dialog, &StartDialog::presetChosen};
    QSignalSpy files{&dialog, &StartDialog::fileChosen};
    QSignalSpy openings{&dialog, &StartDialog::openRequested};
    QSignalSpy finished{&dialog, &QDialog::finished};

    Shown() { dialog.show(); }
    template <class Widget>
    [[nodiscard]] Widget& part(const char* name) const
    {
        return *dialog.findChild<Widget*>(QLatin1String(name));
    }
};

class OneClickStyle : public QProxyStyle {
public:
    int styleHint(
        StyleHint hint, const QStyleOption* option, const QWidget* widget, QStyleHintReturn* more) const override
    {
        return hint == SH_ItemView_ActivateItemOnSingleClick ? 1 : QProxyStyle::styleHint(hint, option, widget, more);
    }
};

void click(QListWidget& list, QListWidgetItem* item)
{
    list.scrollToItem(item);
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(item).center());
}

} // namespace

class StartDialogTest : public QObject {
    Q_OBJECT

private slots:
    void oneClickChoosesAPreset()
    {
        const Shown shown;
        auto& list = shown.part<PresetList>("presetList");
        QTRY_COMPARE(list.count(), sizeOfLibrary());
        QListWidgetItem* item = list.item(2);
        click(list, item);
        QCOMPARE(shown.presets.size(), 1);
        QVERIFY(shown.presets[0][0].value<Preset>().scene == list.presetOf(item)->scene);
        QCOMPARE(shown.dialog.result(), static_cast<int>(QDialog::Accepted));
        QVERIFY(!shown.dialog.isVisible());
    }

    void aSceneOfSeveralLayersStandsOnTopAndOneClickOpensIt()
    {
        const Shown shown;
        auto& card = shown.part<SceneCard>("startCard");
        QTRY_VERIFY(card.isEnabled());
        QVERIFY(!card.text().isEmpty());
        QCOMPARE(card.player().name().isEmpty(), false); // it moves by itself
        QTest::mouseClick(&card, Qt::LeftButton);
        QCOMPARE(shown.presets.size(), 1);
        QVERIFY(shown.presets[0][0].value<Preset>().scene.layers.size() > 1);
        QVERIFY(!shown.dialog.isVisible());
        QVERIFY(card.player().name().isEmpty());
    }

    void scenesComeBeforePresets()
    {
        const Shown shown;
        auto& list = shown.part<PresetList>("presetList");
        QTRY_VERIFY(list.itemOfId(u"volcano"_q) != nullptr); // the last of the library
        QCOMPARE(list.idOf(list.item(0)), u"blast"_q);
        for (int i = 0; i < 5; ++i) {
            QVERIFY(list.presetOf(list.item(i))->scene.layers.size() > 1);
        }
    }

    void whereNothingIsToPlayNothingDoes()
    {
        StartDialog dialog({}, nullptr);
        dialog.setPlays(false);
        dialog.show();
        const auto* card = dialog.findChild<SceneCard*>(u"startCard"_q);
        QTRY_VERIFY(card->isEnabled());
        QVERIFY(card->player().name().isEmpty());
    }

    void oneClickChoosesAFileOfLastTime()
    {
        const Shown shown;
        auto& list = shown.part<QListWidget>("startRecent");
        QCOMPARE(list.count(), 2);
        QCOMPARE(list.item(0)->text(), u"old fire"_q);
        QCOMPARE(list.item(0)->toolTip(), kRecent[0]);
        click(list, list.item(1));
        QCOMPARE(shown.files.size(), 1);
        QCOMPARE(shown.files[0][0].toString(), kRecent[1]);
        QVERIFY(!shown.dialog.isVisible());
    }

    /// As desktops have it that activate what is clicked.
    void whereAClickActivatesItChoosesOnceAllTheSame()
    {
        OneClickStyle style;
        {
            const Shown shown;
            auto& list = shown.part<QListWidget>("startRecent");
            list.setStyle(&style);
            click(list, list.item(1));
            QCOMPARE(shown.files.size(), 1);
            QCOMPARE(shown.finished.size(), 1);
        }
        const Shown shown;
        auto& list = shown.part<PresetList>("presetList");
        list.setStyle(&style);
        QTRY_COMPARE(list.count(), sizeOfLibrary());
        click(list, list.item(2));
        QCOMPARE(shown.presets.size(), 1);
        QCOMPARE(shown.finished.size(), 1);
    }

    void withoutFilesOfLastTimeThereIsAWordInTheirPlace()
    {
        StartDialog dialog({}, nullptr);
        QSignalSpy chosen(&dialog, &StartDialog::fileChosen);
        dialog.show();
        auto& list = *dialog.findChild<QListWidget*>(u"startRecent"_q);
        QCOMPARE(list.count(), 1);
        QVERIFY(!list.item(0)->text().isEmpty());
        click(list, list.item(0)); // it is no file
        QVERIFY(chosen.isEmpty() && dialog.isVisible());
    }

    void aFileIsAskedForOnceTheDialogIsGone()
    {
        const Shown shown;
        bool wasVisible = true;
        connect(
            &shown.dialog, &StartDialog::openRequested, &shown.dialog, [&] { wasVisible = shown.dialog.isVisible(); });
        QTest::mouseClick(&shown.part<QPushButton>("startOpen"), Qt::LeftButton);
        QCOMPARE(shown.openings.size(), 1);
        QVERIFY(!wasVisible);
    }

    void returnTakesTheDefaultSmoke()
    {
        Shown shown;
        QVERIFY(shown.part<QPushButton>("startDefault").isDefault());
        QTest::keyClick(&shown.dialog, Qt::Key_Return);
        QCOMPARE(shown.finished.size(), 1);
        QVERIFY(shown.presets.isEmpty() && shown.files.isEmpty() && shown.openings.isEmpty());
    }

    void returnTakesTheSceneThatHasTheKeyboard()
    {
        Shown shown;
        const QSignalSpy defaults(&shown.dialog, &StartDialog::defaultRequested);
        auto& card = shown.part<SceneCard>("startCard");
        QTRY_VERIFY(card.isEnabled());
        card.setFocus();
        QTest::keyClick(&card, Qt::Key_Return);
        QCOMPARE(shown.presets.size(), 1);
        QVERIFY(defaults.isEmpty());
    }

    void itComesAgainUnlessItIsToldNotTo()
    {
        const Shown shown;
        QVERIFY(shown.dialog.showAgain());
        QTest::mouseClick(&shown.part<QCheckBox>("startAgain"), Qt::LeftButton, {},
            {8, shown.part<QCheckBox>("startAgain").height() / 2});
        QVERIFY(!shown.dialog.showAgain());
    }
};

FUMAGE_TEST_MAIN(StartDialogTest)
#include "start_dialog_test.moc"
