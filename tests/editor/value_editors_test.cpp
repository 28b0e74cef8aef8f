#include "panel_fixture.h"

#include "tests/pictures.h"

#include "ui/document/key_edits.h"
#include "ui/panels/angle_dial.h"
#include "ui/panels/curve_editor.h"
#include "ui/panels/gradient_editor.h"
#include "ui/panels/gradient_presets.h"
#include "ui/panels/number_field.h"
#include "ui/panels/number_slider.h"
#include "ui/panels/picture_editor.h"
#include "ui/panels/vector_editors.h"

#include "core/effect/known_parameter.h"
#include "core/effect/value.h"

#include <QColorDialog>
#include <QDragEnterEvent>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QTimer>
#include <QToolButton>
#include <QUrl>
#include <QtMath>

#include <glm/geometric.hpp>

using namespace fumage;
using namespace fumage::tests;

class ValueEditorsTest : public PanelFixture {
    Q_OBJECT

private slots:
    // --- gradients
    // ----------------------------------------------------------------------------------------------------

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

    void aColourThatIsGivenUpLeavesNoKeyFrame()
    {
        const Parameter& colour = knownParameter("light.colour");
        auto* swatch = childOf<QToolButton>(*m_panel, u"light.colour.swatch"_q);
        const auto open = [&] {
            swatch->click();
            const QList<QColorDialog*> dialogs = m_panel->findChildren<QColorDialog*>(u"colourDialog"_q);
            return dialogs.constLast(); // one that was closed may be there still
        };
        m_document->setAutoKey(true);
        const Scene before = m_document->scene();
        QColorDialog* dialog = open();
        dialog->setCurrentColor(Qt::red);
        QVERIFY(m_document->track(colour) != nullptr);
        dialog->reject();
        QVERIFY(m_document->scene() == before);
        QVERIFY(!m_document->undoStack()->canUndo());
        // One that is only looked at while the time goes on leaves none either.
        const Track track{&colour, {{0.0, glm::vec3(0.1F)}, {2.0, glm::vec3(0.9F)}}};
        replaceTracks(*m_document, {track}, QStringLiteral("Set"));
        const Scene keyed = m_document->scene();
        m_document->setSeconds(0.5);
        dialog = open();
        m_document->setSeconds(1.0);
        dialog->reject();
        QVERIFY(m_document->scene() == keyed);
    }

    void aColourThatIsNotTouchedStaysAsItIs()
    {
        const Parameter& colour = knownParameter("light.colour");
        m_document->edit(colour, glm::vec3(1.5F, 0.123F, 0.456F)); // brighter than a screen
        const Value before = colour.get(m_document->effect());
        childOf<QToolButton>(*m_panel, u"light.colour.swatch"_q)->click();
        childOf<QColorDialog>(*m_panel, u"colourDialog"_q)->accept();
        QVERIFY(colour.get(m_document->effect()) == before);
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
