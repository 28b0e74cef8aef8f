#include "panel_fixture.h"

#include "tests/parameter_rows.h"

#include "ui/document/number_text.h"
#include "ui/panels/number_field.h"
#include "ui/panels/number_slider.h"
#include "ui/panels/whole_box.h"

#include <QToolTip>

using namespace fumage;
using namespace fumage::tests;

class NumberFieldsTest : public PanelFixture {
    Q_OBJECT

private slots:
    // --- numbers ----------------------------------------------------------------------------------------------------

    void numbersAreReadWithUnitsAndBothDecimalSigns_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("unit");
        QTest::addColumn<double>("expected"); // NaN: refused
        const auto add = [](const char* text, Unit unit, double expected) {
            QTest::newRow(text) << QString::fromUtf8(text) << static_cast<int>(unit) << expected;
        };
        add("1.5", Unit::Metres, 1.5);
        add("1,5", Unit::Metres, 1.5);
        add(" -2 m ", Unit::Metres, -2.0);
        add("150 cm", Unit::Metres, 1.5);
        add("150cm", Unit::Metres, 1.5);
        add("500 ms", Unit::Seconds, 0.5);
        add("36 km/h", Unit::MetresPerSecond, 10.0);
        add("150 cm/s²", Unit::MetresPerSecond2, 1.5);
        add("\u22123", Unit::None, -3.0);
        add("1e3", Unit::None, 1000.0);
        add("50%", Unit::None, 0.5);
        add("20k", Unit::None, 20000.0);
        add("45\u00b0", Unit::Degrees, 45.0);
        add("45", Unit::Degrees, 45.0);
        add("nan", Unit::None, qQNaN());
        add("inf", Unit::None, qQNaN());
        add("1e999", Unit::None, qQNaN());
        add("5 kg", Unit::Metres, qQNaN());
        add("five", Unit::Metres, qQNaN());
        add("", Unit::Metres, qQNaN());
        add("1.2.3", Unit::Metres, qQNaN());
        add("2*3", Unit::None, 6.0);
        add("1/3", Unit::None, 1.0 / 3.0);
        add("2 + 3 * 4 m", Unit::Metres, 14.0);
        add("(2 + 3) * 40 cm", Unit::Metres, 2.0);
        add("1,5 - 2,5 - 1", Unit::None, -2.0);
        add("-(1 - -2)", Unit::None, -3.0);
        add("8 / 2 / 2", Unit::None, 2.0);
        add("3 / 0", Unit::None, qQNaN());
        add("(2", Unit::None, qQNaN());
        add("2)", Unit::None, qQNaN());
        add("2 *", Unit::None, qQNaN());
        add("2 3", Unit::None, qQNaN());
        add(QByteArray(100, '(') + "1" + QByteArray(100, ')'), Unit::None, qQNaN());
    }
    void numbersAreReadWithUnitsAndBothDecimalSigns()
    {
        QFETCH(QString, text);
        QFETCH(int, unit);
        QFETCH(double, expected);
        const std::optional<double> number = parseNumber(text, static_cast<Unit>(unit));
        QCOMPARE(number.has_value(), !qIsNaN(expected));
        if (number) {
            QVERIFY(qAbs(*number - expected) <= 1e-12 * qMax(1.0, qAbs(expected)));
        }
    }

    void thousandsAreReadByLanguageAndKind_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("whole");
        QTest::addColumn<double>("expected"); // not a number: refused
        const auto add = [](const char* language, const QString& text, bool whole, double expected) {
            QTest::addRow("%s %s %s", language, qPrintable(text), whole ? "whole" : "real")
                << QString::fromLatin1(language) << text << whole << expected;
        };
        for (const char* language : {"C", "en", "de", "sv", "fr", "de_CH", "zh_CN"}) {
            // Groups of three that can mean nothing else, whatever the number and the language.
            for (const bool whole : {true, false}) {
                for (const QString& text : {u"1,000,000"_q, u"1.000.000"_q, u"1 000 000"_q, u"1'000'000"_q,
                         u"1\u2019000\u2019000"_q, u"1\u00a0000\u00a0000"_q, u"1\u202f000\u202f000"_q}) {
                    add(language, text, whole, 1e6);
                }
                add(language, u"20 000"_q, whole, 20000.0);
                add(language, u"1'000"_q, whole, 1000.0);
                add(language, u"1,234.5"_q, whole, 1234.5);
                add(language, u"1.234,5"_q, whole, 1234.5);
                add(language, u"1 234,5"_q, whole, 1234.5);
                add(language, u"1,5"_q, whole, 1.5);
                add(language, u"1.5"_q, whole, 1.5);
                add(language, u"0,125"_q, whole, 0.125);
                add(language, u"0.125"_q, whole, 0.125);
                add(language, u"1234,567"_q, whole, 1234.567);
                add(language, u"-2 000"_q, whole, -2000.0);
                add(language, u"1 000 + 1.5"_q, whole, 1001.5);
                for (const QString& text : {u"1,00,000"_q, u"1.2.3"_q, u"1,2,3"_q, u"12 34"_q, u"1 2345"_q,
                         u"1,234,5"_q, u"1.234.56,7"_q, u"1'00"_q, u"1,000.000,0"_q, u"0 000"_q, u","_q}) {
                    add(language, text, whole, qQNaN());
                }
            }
            // One sign before three digits: thousands of a whole number everywhere.
            add(language, u"10,000"_q, true, 10000.0);
            add(language, u"1,920"_q, true, 1920.0);
            add(language, u"5.000"_q, true, 5000.0);
        }
        // Of another number what the sign means in the language.
        add("en", u"1,920"_q, false, 1920.0);
        add("en", u"1.920"_q, false, 1.92);
        add("de", u"1.920"_q, false, 1920.0);
        add("de", u"1,920"_q, false, 1.92);
        add("sv", u"1,920"_q, false, 1.92);
        add("sv", u"1.920"_q, false, 1.92);
    }
    void thousandsAreReadByLanguageAndKind()
    {
        QFETCH(QString, language);
        QFETCH(QString, text);
        QFETCH(bool, whole);
        QFETCH(double, expected);
        const QLocale before;
        QLocale::setDefault(QLocale(language));
        const std::optional<double> number = parseNumber(text, Unit::None, whole);
        QLocale::setDefault(before);
        QCOMPARE(number.has_value(), !qIsNaN(expected));
        QCOMPARE(number.value_or(0.0), qIsNaN(expected) ? 0.0 : expected);
    }

    void whatIsShownInAnyLanguageIsReadAsTheSame()
    {
        const QLocale before;
        for (const char* language : {"C", "en", "de", "sv", "fr", "de_CH", "zh_CN"}) {
            QLocale::setDefault(QLocale(QString::fromLatin1(language)));
            for (const double value : {0.125, 1.125, 12.125, 123.45, 1234.5, 5000.0, 1e6}) {
                QCOMPARE(*parseNumber(formatNumber(value), Unit::None), value);
                QCOMPARE(*parseNumber(formatFixed(value, 3), Unit::None), value);
            }
        }
        QLocale::setDefault(before);
    }

    void aSpinBoxReadsThousandsAsFieldsDo()
    {
        WholeBox box;
        box.setKeyboardTracking(false); // or a part of what is typed would count
        box.setRange(1, 10000000);
        box.setSuffix(u" frames"_q);
        for (const QString& text : {u"10,000"_q, u"10.000"_q, u"10 000"_q, u"10'000 frames"_q, u"5000 * 2"_q}) {
            box.setValue(1);
            box.selectAll();
            QTest::keyClicks(&box, text);
            QTest::keyClick(&box, Qt::Key_Return);
            QVERIFY2(box.value() == 10000, qPrintable(text + u" is read as "_q + QString::number(box.value())));
        }
        box.setRange(1, 240);
        box.selectAll();
        QTest::keyClicks(&box, u"23.976"_q);
        QTest::keyClick(&box, Qt::Key_Return);
        QCOMPARE(box.value(), 24);
        box.setRange(1, 10000000);
        box.setValue(10000);
        box.selectAll();
        QTest::keyClicks(&box, u"1,00,0"_q);
        QTest::keyClick(&box, Qt::Key_Return);
        QCOMPARE(box.value(), 10000);
        QCOMPARE(box.text(), u"10000 frames"_q);
    }

    void aNumberReadsBackAsItIsShown()
    {
        for (const double value : {0.1, -3.25, 1234.5, 99999.4, 99999.6, 123456.7, 2222854.348, -2222854.348,
                 4294967294.7, 4294967296.0, 1e-7, 1e12}) {
            const QString shown = formatNumber(value);
            QCOMPARE(formatNumber(parseNumber(shown, Unit::None).value()), shown);
        }
        QCOMPARE(formatNumber(2222854.348), u"2222854"_q);
        QCOMPARE(formatNumber(99999.6), u"100000"_q);
    }

    void theDecimalSignIsThatOfTheLanguage()
    {
        const QLocale before;
        QLocale::setDefault(QLocale(QLocale::Swedish));
        const QString swedish = formatNumber(1234.5, Unit::Metres);
        const QString several = formatNumbers({0.5, 1.0});
        const std::optional<double> again = parseNumber(swedish, Unit::Metres);
        QLocale::setDefault(before);
        QCOMPARE(swedish, u"1234,5 m"_q);
        QCOMPARE(several, u"0,5; 1"_q);
        QCOMPARE(*again, 1234.5);
        QCOMPARE(formatNumber(1234.5, Unit::Metres), u"1234.5 m"_q);
    }

    void aNumberIsShownWithAsManyDigitsAsFitAndReadWhole()
    {
        NumberField field({{-1000.0, 1000.0}, {0.0, 1.0}, 0.01, false, false, Unit::Metres});
        field.setValue(-0.18811);
        for (const int width : {200, 90, 80, 72}) {
            field.resize(width, field.sizeHint().height());
            const QString text = field.text();
            const std::optional<double> shown = parseNumber(text, Unit::Metres);
            QVERIFY2(shown && qAbs(*shown + 0.18811) < 2e-3, qPrintable(text));
            QVERIFY2(field.fontMetrics().horizontalAdvance(text) <= width, qPrintable(text));
            QCOMPARE(field.value(), -0.18811);
        }
    }

    void radiansBecomeDegrees()
    {
        QVERIFY(qAbs(*parseNumber(u"3.14159265358979 rad"_q, Unit::Degrees) - 180.0) < 1e-9);
    }

    void aSliderGoesOverItsSoftRangeAndBack_data() { addParameterRows(); }
    void aSliderGoesOverItsSoftRangeAndBack()
    {
        QFETCH(QString, key);
        const Parameter& parameter = *findParameter(key.toStdString());
        if (parameter.kind != Kind::Float && parameter.kind != Kind::Int) {
            return;
        }
        const NumberScale scale = NumberScale::of(parameter);
        QVERIFY(qAbs(scale.valueAt(0.0) - scale.soft.low) <= 0.5 * scale.step);
        QVERIFY(qAbs(scale.valueAt(1.0) - scale.soft.high) <= qMax(0.5 * scale.step, 1e-3 * scale.soft.high));
        QCOMPARE(scale.position(scale.soft.low), 0.0);
        QCOMPARE(scale.position(scale.soft.high), 1.0);
        double last = scale.valueAt(0.0);
        for (int i = 1; i <= 50; ++i) {
            const double next = scale.valueAt(i / 50.0);
            QVERIFY(next >= last && next >= scale.hard.low && next <= scale.hard.high);
            last = next;
        }
    }

    void typingWithoutChangingCommitsNothing()
    {
        // The field shows five digits of a longer number; passing through it must not round the document.
        Preset preset;
        preset.scene.wind.strength = 0.123456789F;
        m_document->load(preset, {});
        NumberField* field = this->field("wind.strength.field");
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Tab);
        QVERIFY(m_document->effect() == preset.scene.effect());
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void nonsenseIsRefusedAndTheOldNumberStays()
    {
        NumberField* field = this->field("wind.strength.field");
        const QString before = field->text();
        typeInto(*field, u"windy"_q);
        QCOMPARE(field->text(), before);
        QVERIFY(m_document->effect() == Effect());
    }

    void aNumberThatIsTooLargeIsTheLargestAndSaysSo()
    {
        NumberField* field = this->field("wind.strength.field");
        const double largest = findParameter("wind.strength")->hard.high;
        typeInto(*field, u"1e9"_q);
        QCOMPARE(field->value(), largest);
        QTRY_VERIFY(QToolTip::isVisible());
        QVERIFY(QToolTip::text().contains(formatNumber(largest)));
    }

    void escapePutsBackWhatWasThere()
    {
        NumberField* field = this->field("wind.strength.field");
        const QString before = field->text();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, u"3"_q);
        QTest::keyClick(field, Qt::Key_Escape);
        QCOMPARE(field->text(), before);
        QVERIFY(m_document->effect() == Effect());
    }

    void aFieldIsDraggedSidewaysWithFineAndSnappingKeys()
    {
        NumberField* field = this->field("motion.gravity.field");
        const QPoint from(field->width() / 2, field->height() / 2);
        dragMouse(*field, from, from + QPoint(20, 0));
        const float coarse = m_document->effect().motion.gravity;
        QCOMPARE(coarse, 20 * 0.05F);
        QCOMPARE(m_document->undoStack()->count(), 1);
        m_document->undoStack()->undo();
        dragMouse(*field, from, from + QPoint(20, 0), Qt::LeftButton, Qt::ShiftModifier);
        QCOMPARE(m_document->effect().motion.gravity, coarse / 10.0F);
        m_document->undoStack()->undo();
        dragMouse(*field, from, from + QPoint(24, 0), Qt::LeftButton, Qt::ControlModifier);
        QCOMPARE(m_document->effect().motion.gravity, 1.0F);
        QVERIFY(!field->hasFocus());
    }

    void theWheelIsDeafWithoutTheFocus()
    {
        NumberField* field = this->field("motion.gravity.field");
        QVERIFY(!field->hasFocus());
        turnWheel(*field, 3);
        auto* slider = m_panel->findChild<NumberSlider*>(u"motion.gravity.slider"_q);
        turnWheel(*slider, 3);
        QVERIFY(m_document->effect() == Effect());
    }

    void aBurstOfTheWheelIsOneStep()
    {
        NumberField* field = this->field("motion.gravity.field");
        field->setFocus();
        for (int i = 0; i < 5; ++i) {
            turnWheel(*field, 1);
        }
        QVERIFY(m_document->effect().motion.gravity > 0.0F);
        QCOMPARE(m_document->undoStack()->count(), 1);
    }
};

FUMAGE_TEST_MAIN(NumberFieldsTest)
#include "number_fields_test.moc"
