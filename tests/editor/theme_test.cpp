// What is drawn can be told from what it is drawn on. Contrast as in WCAG 2.2: 4.5 for text, 3 for the edges of
// controls.
#include "editor_helpers.h"

#include "ui/widgets/choice_question.h"
#include "ui/theme/theme.h"

#include <QCheckBox>
#include <QPushButton>
#include <QTimer>

#include <cmath>

using namespace fumage::tests;

namespace {

double luminance(QRgb colour)
{
    const auto linear = [](int channel) {
        const double share = channel / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(qRed(colour)) + 0.7152 * linear(qGreen(colour)) + 0.0722 * linear(qBlue(colour));
}

double contrast(QRgb one, QRgb other)
{
    const double a = luminance(one);
    const double b = luminance(other);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

} // namespace

class ThemeTest : public QObject {
    Q_OBJECT

private slots:
    void textIsReadOnWhatItStandsOn_data() { addThemes(); }
    void textIsReadOnWhatItStandsOn()
    {
        const ThemeColours& colours = chosen();
        for (const QRgb text : {colours.text, colours.quiet, colours.mark, colours.good}) {
            for (const QRgb behind : {colours.window, colours.base, colours.raised}) {
                compare(text, behind, 4.5);
            }
        }
        compare(colours.onAccent, colours.accent, 4.5);
    }

    void theEdgeOfABoxIsSeen_data() { addThemes(); }
    void theEdgeOfABoxIsSeen()
    {
        const ThemeColours& colours = chosen();
        compare(colours.control, colours.window, 3.0);
        compare(colours.control, colours.base, 3.0);
    }

    void longAnswersOfAQuestionAreWhole()
    {
        applyTheme(*qApp, Theme::Dark, true);
        QList<int> missing;
        QTimer::singleShot(0, qApp, [&] {
            QWidget* box = QApplication::activeModalWidget();
            for (const QPushButton* button : box->findChildren<QPushButton*>()) {
                missing += std::max(0, button->sizeHint().width() - button->width());
            }
            box->close();
        });
        static_cast<void>(askInBox(nullptr,
            {.name = u"box"_q,
                .title = u"Exports"_q,
                .text = u"Some"_q,
                .answers = {
                    u"Finish in the background and close the window"_q, u"Stop them and close"_q, u"Cancel"_q}}));
        QCOMPARE(missing, (QList<int>{0, 0, 0}));
    }

    void anEmptyBoxHasThatEdgeOnTheScreen_data() { addThemes(); }
    void anEmptyBoxHasThatEdgeOnTheScreen()
    {
        QFETCH(bool, dark);
        applyTheme(*qApp, dark ? Theme::Dark : Theme::Light, dark);
        QCheckBox box;
        box.ensurePolished();
        box.resize(box.sizeHint());
        const QImage seen = box.grab().toImage();
        double best = 0.0;
        for (int x = 0; x < seen.width(); ++x) {
            best = std::max(best, contrast(seen.pixel(x, seen.height() / 2), chosen().window));
        }
        QVERIFY2(best >= 3.0, qPrintable(QString::number(best)));
    }

private:
    static void addThemes()
    {
        QTest::addColumn<bool>("dark");
        QTest::newRow("dark") << true;
        QTest::newRow("light") << false;
    }

    static const ThemeColours& chosen()
    {
        QFETCH(bool, dark);
        return themeColours(dark);
    }

    static void compare(QRgb one, QRgb other, double least)
    {
        const double seen = contrast(one, other);
        QVERIFY2(seen >= least, qPrintable(u"%1 on %2: %3"_q.arg(QColor(one).name(), QColor(other).name()).arg(seen)));
    }
};

FUMAGE_TEST_MAIN(ThemeTest)
#include "theme_test.moc"
