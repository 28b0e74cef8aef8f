#include "panel_fixture.h"

#include "tests/parameter_rows.h"

#include "ui/document/number_text.h"
#include "ui/panels/angle_dial.h"
#include "ui/panels/curve_editor.h"
#include "ui/panels/gradient_editor.h"
#include "ui/panels/number_slider.h"
#include "ui/panels/vector_editors.h"

#include "core/effect/known_parameter.h"

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
        const auto add = [](const char* text, Unit unit, double expected) { QTest::newRow(text) << QString::fromUtf8(text) << static_cast<int>(unit) << expected; };
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

    void aNumberReadsBackAsItIsShown()
    {
        for (const double value : {0.1, -3.25, 1234.5, 99999.4, 99999.6, 123456.7, 2222854.348, -2222854.348, 4294967294.7, 4294967296.0, 1e-7, 1e12}) {
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
        preset.effect.motion.wind = 0.123456789F;
        m_document->load(preset, {});
        NumberField* field = this->field("motion.wind.field");
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Tab);
        QVERIFY(m_document->effect() == preset.effect);
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void nonsenseIsRefusedAndTheOldNumberStays()
    {
        NumberField* field = this->field("motion.wind.field");
        const QString before = field->text();
        typeInto(*field, u"windy"_q);
        QCOMPARE(field->text(), before);
        QVERIFY(m_document->effect() == Effect());
    }

    void aNumberThatIsTooLargeIsTheLargestAndSaysSo()
    {
        NumberField* field = this->field("motion.wind.field");
        const double largest = findParameter("motion.wind")->hard.high;
        typeInto(*field, u"1e9"_q);
        QCOMPARE(field->value(), largest);
        QTRY_VERIFY(QToolTip::isVisible());
        QVERIFY(QToolTip::text().contains(formatNumber(largest)));
    }

    void escapePutsBackWhatWasThere()
    {
        NumberField* field = this->field("motion.wind.field");
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
        oblique.effect.emitter.normal = glm::normalize(glm::vec3(0.0F, 1.0F, 1.0F));
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
        QCOMPARE(m_document->effect().motion.windAngle, 90.0F); // down is towards the viewer
        QCOMPARE(field("motion.wind_angle.field")->text(), u"90\u00b0"_q);
        QCOMPARE(m_document->undoStack()->count(), 1);
        QTest::mouseClick(dial, Qt::LeftButton, {}, placeOn(*dial, 180.0));
        QCOMPARE(m_document->effect().motion.windAngle, 180.0F);
        QCOMPARE(m_document->undoStack()->count(), 2);
        m_document->undoStack()->undo();
        m_document->undoStack()->undo();
        QCOMPARE(m_document->effect().motion.windAngle, 0.0F);
    }

    void theControlKeySnapsADial()
    {
        AngleDial* dial = windDial();
        for (const double angle : {20.0, 50.0, -70.0}) {
            QTest::mouseClick(dial, Qt::LeftButton, Qt::ControlModifier, placeOn(*dial, angle));
            QCOMPARE(m_document->effect().motion.windAngle, static_cast<float>(qRound(angle / 15.0) * 15));
        }
    }

    void aBurstOfKeysOnADialIsOneStep()
    {
        AngleDial* dial = windDial();
        dial->setFocus();
        for (const Qt::Key key : {Qt::Key_Up, Qt::Key_Right, Qt::Key_Up, Qt::Key_Left}) {
            QTest::keyClick(dial, key);
        }
        QCOMPARE(m_document->effect().motion.windAngle, 2.0F);
        QCOMPARE(m_document->undoStack()->count(), 1);
        m_document->undoStack()->undo();
        QCOMPARE(m_document->effect().motion.windAngle, 0.0F);
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
        auto* bar = m_panel->findChild<GradientBar*>(u"light.emission_colours.bar"_q);
        const Gradient before = m_document->effect().light.emissionGradient;
        QTest::mouseClick(bar, Qt::LeftButton, {}, QPoint(bar->width() / 2, 8));
        QCOMPARE(m_document->effect().light.emissionGradient.count, before.count + 1);
        QTest::keyClick(bar, Qt::Key_Delete);
        QVERIFY(m_document->effect().light.emissionGradient == before);
    }

private:
    AngleDial* windDial() { return m_panel->findChild<AngleDial*>(u"motion.wind_angle.dial"_q); }
    /// A place on the rim of a dial.
    static QPoint placeOn(const AngleDial& dial, double degrees)
    {
        const double angle = qDegreesToRadians(degrees);
        return (QRectF(dial.rect()).center() + 12.0 * QPointF(std::cos(angle), std::sin(angle))).toPoint();
    }
};

FUMAGE_TEST_MAIN(ValueEditorsTest)
#include "value_editors_test.moc"
