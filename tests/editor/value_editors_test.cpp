#include "panel_fixture.h"

#include "tests/parameter_rows.h"
#include "tests/pictures.h"

#include "ui/document/number_text.h"
#include "ui/panels/angle_dial.h"
#include "ui/panels/curve_editor.h"
#include "ui/panels/gradient_editor.h"
#include "ui/panels/gradient_presets.h"
#include "ui/panels/number_field.h"
#include "ui/panels/number_slider.h"
#include "ui/panels/picture_editor.h"
#include "ui/panels/vector_editors.h"
#include "ui/panels/whole_box.h"

#include "core/effect/known_parameter.h"
#include "core/effect/value.h"

#include <QDragEnterEvent>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QTimer>
#include <QToolButton>
#include <QToolTip>
#include <QUrl>
#include <QtMath>

#include <glm/geometric.hpp>

using namespace fumage;
using namespace fumage::tests;

class ValueEditorsTest : public PanelFixture {
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

    void aGradientIsReplacedByAPresetInOneStep()
    {
        const Parameter& parameter = knownParameter("glow.emission_colours");
        m_document->edit(knownParameter("glow.emission_colour"), 1); // where its row is seen
        const int steps = m_document->undoStack()->count();
        auto* menu = childOf<QMenu>(*m_panel, u"glow.emission_colours.menu"_q);
        emit menu->aboutToShow();
        QVERIFY(gradientPresets().size() >= 3);
        for (const GradientPreset& preset : gradientPresets()) {
            QVERIFY(preset.gradient.count >= 2);
            QVERIFY(clampValue(parameter, preset.gradient).value == Value(preset.gradient));
            for (QAction* action : menu->actions()) {
                if (action->text() == nameOf(preset)) {
                    action->trigger();
                }
            }
            QVERIFY(parameter.get(m_document->effect()) == Value(preset.gradient));
        }
        QCOMPARE(m_document->undoStack()->count(), steps + static_cast<int>(gradientPresets().size()));
    }

    void turnedHuesKeepStrengthAndComeBack()
    {
        for (const GradientPreset& preset : gradientPresets()) {
            const Gradient turned = hueShifted(preset.gradient, 120.0);
            const Gradient back = hueShifted(hueShifted(turned, 120.0), 120.0);
            for (int i = 0; i < preset.gradient.count; ++i) {
                const auto at = [i](const Gradient& gradient) { return gradient.storage[static_cast<std::size_t>(i)]; };
                const auto most = [](const glm::vec3& c) { return std::max({c.r, c.g, c.b}); };
                const auto least = [](const glm::vec3& c) { return std::min({c.r, c.g, c.b}); };
                QCOMPARE(at(turned).at, at(preset.gradient).at);
                QVERIFY(qAbs(most(at(turned).colour) - most(at(preset.gradient).colour)) < 1e-3F);
                QVERIFY(qAbs(least(at(turned).colour) - least(at(preset.gradient).colour)) < 2e-3F);
                QVERIFY(glm::distance(at(back).colour, at(preset.gradient).colour) < 5e-3F);
            }
            QVERIFY(reversed(reversed(preset.gradient)).count == preset.gradient.count);
        }
        const Gradient red{{0.0F, {4.0F, 0.0F, 0.0F}}, {1.0F, {0.5F, 0.5F, 0.5F}}};
        const Gradient green = hueShifted(red, 120.0);
        QVERIFY(glm::distance(green.storage[0].colour, glm::vec3(0.0F, 4.0F, 0.0F)) < 1e-2F);
        QVERIFY(green.storage[1].colour == red.storage[1].colour); // grey has no hue
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

    // --- directions -------------------------------------------------------------------------------------------------

    void aDirectionStaysAUnitVector()
    {
        typeInto(*field("emitter.normal.x"), u"0.6"_q);
        const glm::vec3 normal = m_document->effect().emitter.normal;
        QVERIFY(qAbs(normal.x - 0.6F) < 1e-4F);
        QVERIFY(qAbs(normal.y - 0.8F) < 1e-4F);
        QVERIFY(qAbs(glm::length(normal) - 1.0F) < 1e-5F);
    }

    void yawAndPitchAreTheSameDirection()
    {
        typeInto(*field("emitter.normal.pitch.field"), u"0"_q);
        typeInto(*field("emitter.normal.yaw.field"), u"90"_q);
        const glm::vec3 normal = m_document->effect().emitter.normal;
        QVERIFY(glm::length(normal - glm::vec3(0.0F, 0.0F, 1.0F)) < 1e-5F);
        QCOMPARE(field("emitter.normal.z")->text(), u"1"_q);
    }

    void aVerticalNormalDoesNotKeepTheYawOfTheDocumentBefore()
    {
        Preset oblique;
        oblique.scene.layers[0].emitter.normal = glm::normalize(glm::vec3(0.0F, 1.0F, 1.0F));
        m_document->load(oblique, {});
        QCOMPARE(field("emitter.normal.yaw.field")->value(), 90.0);
        m_document->load(Preset(), {});
        QCOMPARE(field("emitter.normal.pitch.field")->value(), 90.0);
        QCOMPARE(field("emitter.normal.yaw.field")->value(), 0.0);
    }

    void aComponentCanBeSetWhereTheOthersAreNothing()
    {
        const glm::vec3 up = withComponent({0.0F, 1.0F, 0.0F}, 1, 0.0F);
        QVERIFY(qAbs(glm::length(up) - 1.0F) < 1e-6F);
        QCOMPARE(up.y, 0.0F);
    }

    // --- dials ------------------------------------------------------------------------------------------------------

    void aDialIsTurnedByTheMouseInOneStep()
    {
        AngleDial* dial = windDial();
        dragMouse(*dial, placeOn(*dial, 20.0), placeOn(*dial, 90.0));
        QCOMPARE(m_document->effect().wind.angle, 90.0F); // down is towards the viewer
        QCOMPARE(field("wind.angle.field")->text(), u"90\u00b0"_q);
        QCOMPARE(m_document->undoStack()->count(), 1);
        QTest::mouseClick(dial, Qt::LeftButton, {}, placeOn(*dial, 180.0));
        QCOMPARE(m_document->effect().wind.angle, 180.0F);
        QCOMPARE(m_document->undoStack()->count(), 2);
        m_document->undoStack()->undo();
        m_document->undoStack()->undo();
        QCOMPARE(m_document->effect().wind.angle, 0.0F);
    }

    void theControlKeySnapsADial()
    {
        AngleDial* dial = windDial();
        for (const double angle : {20.0, 50.0, -70.0}) {
            QTest::mouseClick(dial, Qt::LeftButton, Qt::ControlModifier, placeOn(*dial, angle));
            QCOMPARE(m_document->effect().wind.angle, static_cast<float>(qRound(angle / 15.0) * 15));
        }
    }

    void aBurstOfKeysOnADialIsOneStep()
    {
        AngleDial* dial = windDial();
        dial->setFocus();
        for (const Qt::Key key : {Qt::Key_Up, Qt::Key_Right, Qt::Key_Up, Qt::Key_Left}) {
            QTest::keyClick(dial, key);
        }
        QCOMPARE(m_document->effect().wind.angle, 2.0F);
        QCOMPARE(m_document->undoStack()->count(), 1);
        m_document->undoStack()->undo();
        QCOMPARE(m_document->effect().wind.angle, 0.0F);
    }

    void aDialLeavesTheWheelToThePanel()
    {
        AngleDial* dial = windDial();
        dial->setFocus();
        turnWheel(*dial, 3);
        QVERIFY(m_document->effect() == Effect());
    }

    void aPressEndsTheBurstOfKeysBeforeIt()
    {
        AngleDial* dial = windDial();
        dial->setFocus();
        QTest::keyClick(dial, Qt::Key_Up);
        QTest::mouseClick(dial, Qt::LeftButton, {}, placeOn(*dial, 90.0));
        QCOMPARE(m_document->undoStack()->count(), 2);
        auto* slider = m_panel->findChild<NumberSlider*>(u"motion.gravity.slider"_q);
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Right);
        QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() - 20, slider->height() / 2));
        QCOMPARE(m_document->undoStack()->count(), 4);
    }

    // --- curves and gradients ---------------------------------------------------------------------------------------

    void aPointOfACurveIsDraggedAddedAndTakenAway()
    {
        auto* area = m_panel->findChild<CurveArea*>(u"life.size.area"_q);
        const Curve before = m_document->effect().life.sizeCurve;
        const QPoint last = area->toScreen(before.points().back()).toPoint();
        dragMouse(*area, last, last + QPoint(0, 40));
        QCOMPARE(m_document->undoStack()->count(), 1);
        QVERIFY(m_document->effect().life.sizeCurve.points().back().y < before.points().back().y);
        m_document->undoStack()->undo();
        const QPoint middle = area->toScreen({0.7F, 0.2F}).toPoint();
        QTest::mouseClick(area, Qt::LeftButton, {}, middle);
        QCOMPARE(m_document->effect().life.sizeCurve.count, before.count + 1);
        QTest::keyClick(area, Qt::Key_Delete);
        QVERIFY(m_document->effect().life.sizeCurve == before);
    }

    void aStopOfAGradientIsAddedAndTakenAway()
    {
        auto* bar = m_panel->findChild<GradientBar*>(u"glow.emission_colours.bar"_q);
        const Gradient before = m_document->effect().glow.emissionGradient;
        QTest::mouseClick(bar, Qt::LeftButton, {}, QPoint(bar->width() / 2, 8));
        QCOMPARE(m_document->effect().glow.emissionGradient.count, before.count + 1);
        QTest::keyClick(bar, Qt::Key_Delete);
        QVERIFY(m_document->effect().glow.emissionGradient == before);
    }

    // --- pictures ---------------------------------------------------------------------------------------------------

    void aPictureIsChosenShownAndRemoved()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"logo.png"_q);
        const Bitmap logo = ramp(40, 20);
        writePng(path, logo.file());
        PictureEditor editor(knownParameter("emitter.picture"), nullptr, [&](QWidget*, const FileQuestion& question) {
            return question.purpose == FileQuestion::Purpose::Open ? path : QString();
        });
        Value last;
        int count = 0;
        connect(&editor, &ParameterEditor::edited, this, [&](const Value& value, bool finished) {
            QVERIFY(finished);
            last = value;
            ++count;
        });
        auto* choose = childOf<QToolButton>(editor, u"emitter.picture.choose"_q);
        auto* clear = childOf<QToolButton>(editor, u"emitter.picture.clear"_q);
        QVERIFY(!clear->isEnabled() && choose->icon().isNull());
        choose->click();
        QVERIFY(count == 1 && last == Value(logo));
        QVERIFY(clear->isEnabled() && !choose->icon().isNull());
        QCOMPARE(choose->text(), u"40 × 20"_q);
        clear->click();
        QVERIFY(count == 2 && last == Value(Bitmap()));
        editor.setValue(logo);
        QVERIFY(count == 2 && clear->isEnabled());
    }

    void whatIsNoPictureIsSaidAndThePictureBeforeStays()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"broken.png"_q);
        writePng(path, ramp(4, 4).file().first(40));
        PictureEditor editor(
            knownParameter("emitter.picture"), nullptr, [&](QWidget*, const FileQuestion&) { return path; });
        editor.setValue(ramp(3, 3));
        int count = 0;
        connect(&editor, &ParameterEditor::edited, this, [&] { ++count; });
        QString said;
        QTimer::singleShot(0, this, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            said = box->text();
            box->accept();
        });
        childOf<QToolButton>(editor, u"emitter.picture.choose"_q)->click();
        QVERIFY2(said.contains(u"broken.png"_q) && said.contains(u"512"_q), qPrintable(said));
        QCOMPARE(count, 0);
        QCOMPARE(childOf<QToolButton>(editor, u"emitter.picture.choose"_q)->text(), u"3 × 3"_q);
    }

    void aPngIsDroppedOnTheEditorAndOtherFilesAreNot()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"logo.PNG"_q);
        writePng(path, ramp(5, 6).file());
        auto* editor = childOf<PictureEditor>(*m_panel, u"emitter.picture"_q);
        for (const QString& file : {folder.filePath(u"a.json"_q), path}) {
            QMimeData data;
            data.setUrls({QUrl::fromLocalFile(file)});
            QDragEnterEvent enter({}, Qt::CopyAction, &data, Qt::LeftButton, {});
            enter.ignore();
            QApplication::sendEvent(editor, &enter);
            QCOMPARE(enter.isAccepted(), file == path);
            if (enter.isAccepted()) {
                QDropEvent drop({}, Qt::CopyAction, &data, Qt::LeftButton, {});
                QApplication::sendEvent(editor, &drop);
            }
        }
        QTRY_VERIFY(m_document->effect().emitter.picture == ramp(5, 6));
        QCOMPARE(m_document->undoStack()->count(), 1);
        m_document->undoStack()->undo();
        QVERIFY(m_document->effect().emitter.picture.empty());
    }

private:
    static void writePng(const QString& path, std::span<const std::byte> bytes)
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
    }

    AngleDial* windDial() { return m_panel->findChild<AngleDial*>(u"wind.angle.dial"_q); }
    /// A place on the rim of a dial.
    static QPoint placeOn(const AngleDial& dial, double degrees)
    {
        const double angle = qDegreesToRadians(degrees);
        return (QRectF(dial.rect()).center() + 12.0 * QPointF(std::cos(angle), std::sin(angle))).toPoint();
    }
};

FUMAGE_TEST_MAIN(ValueEditorsTest)
#include "value_editors_test.moc"
