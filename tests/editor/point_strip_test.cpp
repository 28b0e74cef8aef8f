// What the hand does with the points of a curve and with the stops of a gradient is one and the same.
#include "editor_helpers.h"

#include "ui/panels/curve_editor.h"
#include "ui/panels/gradient_editor.h"
#include "ui/panels/parameter_row.h"

#include <QLabel>
#include <QMenu>

using namespace fumage;
using namespace fumage::tests;

class PointStripTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_document = std::make_unique<Document>();
        m_locks = std::make_unique<Locks>();
    }
    void cleanup()
    {
        m_row.reset();
        m_document.reset();
    }

    void aPressBesideThePointsAddsOneAndDragsItInOneStep_data() { addStrips(); }
    void aPressBesideThePointsAddsOneAndDragsItInOneStep()
    {
        open({0.2F, 0.5F, 0.8F});
        dragMouse(*m_strip, beside(0.3F), beside(0.4F));
        QCOMPARE(places().size(), 4);
        QVERIFY(qAbs(places()[1] - 0.4F) < 0.01F);
        QCOMPARE(m_document->undoStack()->count(), 1);
        m_document->undoStack()->undo();
        QCOMPARE(places(), (QList<float>{0.2F, 0.5F, 0.8F}));
    }

    void aPointStaysBetweenItsNeighbours_data() { addStrips(); }
    void aPointStaysBetweenItsNeighbours()
    {
        open({0.2F, 0.5F, 0.8F});
        dragMouse(*m_strip, pointOf(1), pointOf(1) + QPoint(m_strip->width(), 0));
        QVERIFY(places()[1] > 0.78F && places()[1] <= 0.8F);
        QCOMPARE(places()[2], 0.8F);
        dragMouse(*m_strip, pointOf(0), pointOf(0) - QPoint(m_strip->width(), 0));
        QCOMPARE(places()[0], 0.0F);
        QCOMPARE(m_document->undoStack()->count(), 2);
    }

    void theRightButtonChangesNothing_data() { addStrips(); }
    void theRightButtonChangesNothing()
    {
        open({0.2F, 0.5F, 0.8F});
        for (const QPoint at : {beside(0.3F), pointOf(1)}) {
            QTest::mouseClick(m_strip, Qt::RightButton, {}, at);
            QCOMPARE(places(), (QList<float>{0.2F, 0.5F, 0.8F}));
        }
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void theMenuAndDeleteTakeAllButTheLastAway_data() { addStrips(); }
    void theMenuAndDeleteTakeAllButTheLastAway()
    {
        open({0.2F, 0.5F, 0.8F});
        QVERIFY(deletionAt(beside(0.3F)) == nullptr);
        deletionAt(pointOf(1))->trigger();
        QCOMPARE(places(), (QList<float>{0.2F, 0.8F}));
        QTest::keyClick(m_strip, Qt::Key_Delete); // the one that took its place
        QCOMPARE(places(), QList<float>{0.2F});
        QTest::keyClick(m_strip, Qt::Key_Backspace);
        QVERIFY(!deletionAt(pointOf(0))->isEnabled());
        QCOMPARE(places(), QList<float>{0.2F});
        QCOMPARE(m_document->undoStack()->count(), 2);
    }

    void aHintTellsWhatTheHandCanDo_data() { addStrips(); }
    void aHintTellsWhatTheHandCanDo()
    {
        open({0.2F, 0.5F});
        const auto* hint = m_row->findChild<QLabel*>(m_row->editor().objectName() + u".hint"_q);
        QVERIFY(hint != nullptr && hint->isVisible() && hint->text().contains(u"add"_q));
    }

    void keysGoFromPointToPointAndMoveThem_data() { addStrips(); }
    void keysGoFromPointToPointAndMoveThem()
    {
        open({0.2F, 0.5F, 0.8F});
        QTest::keyClick(m_strip, Qt::Key_PageUp); // there is none before the first
        QTest::keyClick(m_strip, Qt::Key_PageDown);
        QTest::keyClick(m_strip, Qt::Key_Right);
        QCOMPARE(places(), (QList<float>{0.2F, 0.51F, 0.8F}));
        QTest::keyClick(m_strip, Qt::Key_PageDown);
        QTest::keyClick(m_strip, Qt::Key_PageDown); // nor one after the last
        QTest::keyClick(m_strip, Qt::Key_Left);
        QCOMPARE(places(), (QList<float>{0.2F, 0.51F, 0.79F}));
        QTest::keyClick(m_strip, Qt::Key_PageUp);
        QTest::keyClick(m_strip, Qt::Key_Insert); // a tenth on
        QCOMPARE(places(), (QList<float>{0.2F, 0.51F, 0.61F, 0.79F}));
        QCOMPARE(m_document->undoStack()->count(), 3);
    }

    void onlyTheCurveKnowsUpAndDown_data() { addStrips(); }
    void onlyTheCurveKnowsUpAndDown()
    {
        open({0.2F, 0.5F, 0.8F});
        const Value before = parameter().get(m_document->effect());
        QTest::keyClick(m_strip, Qt::Key_Up);
        const bool moves = parameter().kind == Kind::Curve;
        QCOMPARE(m_document->undoStack()->count(), moves ? 1 : 0);
        QTest::keyClick(m_strip, Qt::Key_Down);
        QVERIFY(before == parameter().get(m_document->effect()));
    }

    void aFullStripTakesNoMoreAndDragsNone_data() { addStrips(); }
    void aFullStripTakesNoMoreAndDragsNone()
    {
        QList<float> all;
        for (int i = 0; i < kMaxControlPoints; ++i) {
            all += static_cast<float>(i) / 64.0F;
        }
        open(all);
        dragMouse(*m_strip, beside(0.6F), beside(0.9F));
        QTest::keyClick(m_strip, Qt::Key_Insert);
        QCOMPARE(places(), all);
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void whatTheHandHoldsIsNotTakenFromIt_data() { addStrips(); }
    void whatTheHandHoldsIsNotTakenFromIt()
    {
        open({0.2F, 0.5F, 0.8F});
        const Value before = parameter().get(m_document->effect());
        QTest::mousePress(m_strip, Qt::LeftButton, {}, pointOf(1));
        QTest::mouseMove(m_strip, pointOf(1) + QPoint(12, 0));
        m_row->editor().setValue(before);
        QTest::mouseRelease(m_strip, Qt::LeftButton, {}, pointOf(1));
        QVERIFY(places()[1] > 0.52F);
        QCOMPARE(m_document->undoStack()->count(), 1);
    }

    void pointsAreKeptInOrderAndNothingIsLeftBehindTheLast()
    {
        Curve curve{{0.1F, 1.0F}, {0.5F, 1.0F}};
        QCOMPARE(insertPoint(curve, CurvePoint{0.5F, 0.3F}), 2);
        QCOMPARE(insertPoint(curve, CurvePoint{0.0F, 0.2F}), 0);
        QVERIFY((curve == Curve{{0.0F, 0.2F}, {0.1F, 1.0F}, {0.5F, 1.0F}, {0.5F, 0.3F}}));
        removePoint(curve, 1);
        removePoint(curve, 2);
        QVERIFY((curve == Curve{{0.0F, 0.2F}, {0.5F, 1.0F}}));
    }

private:
    static void addStrips()
    {
        QTest::addColumn<QString>("key");
        QTest::newRow("curve") << u"life.size"_q;
        QTest::newRow("gradient") << u"glow.emission_colours"_q;
    }

    /// Shows the parameter that is asked for, with points at these places.
    void open(const QList<float>& at)
    {
        QFETCH(QString, key);
        const Parameter& parameter = *findParameter(key.toStdString());
        Preset preset;
        if (parameter.kind == Kind::Curve) {
            Curve curve;
            for (const float x : at) {
                curve.storage[static_cast<std::size_t>(curve.count++)] = {x, 0.5F};
            }
            Effect changed = preset.scene.effect();
            parameter.set(changed, curve);
            preset.scene = changed;
        } else {
            Gradient gradient;
            for (const float x : at) {
                gradient.storage[static_cast<std::size_t>(gradient.count++)] = {x, {x, 0.5F, 0.2F}};
            }
            Effect changed = preset.scene.effect();
            parameter.set(changed, gradient);
            preset.scene = changed;
        }
        m_document->load(preset, {});
        m_row = std::make_unique<ParameterRow>(parameter, *m_document, *m_locks, nullptr);
        connect(m_document.get(), &Document::effectChanged, m_row.get(), &ParameterRow::sync);
        m_row->sync();
        m_row->resize(380, 140);
        m_row->show();
        m_strip = m_row->findChild<PointStrip*>();
        m_strip->setFocus();
        QVERIFY(QTest::qWaitForWindowExposed(m_row.get()));
    }

    [[nodiscard]] const Parameter& parameter() const { return m_row->parameter(); }

    [[nodiscard]] QList<float> places() const
    {
        QList<float> out;
        const Value value = parameter().get(m_document->effect());
        if (const auto* curve = std::get_if<Curve>(&value)) {
            for (const CurvePoint& point : curve->points()) {
                out += point.x;
            }
        } else {
            for (const GradientStop& stop : std::get<Gradient>(value).stops()) {
                out += stop.at;
            }
        }
        return out;
    }

    /// What the menu offers to take a point away; null where there is none. The menu is the next one's end.
    QAction* deletionAt(QPoint at)
    {
        m_menu = std::make_unique<QMenu>();
        m_row->editor().addActions(*m_menu, m_strip->mapToGlobal(at));
        for (QAction* action : m_menu->actions()) {
            if (action->text() == u"Delete the point"_q) {
                return action;
            }
        }
        return nullptr;
    }

    [[nodiscard]] QPoint pointOf(int index) const
    {
        if (const auto* area = qobject_cast<CurveArea*>(m_strip)) {
            return area->toScreen(area->curve().points()[static_cast<std::size_t>(index)]).toPoint();
        }
        return qobject_cast<GradientBar*>(m_strip)->handle(index).toPoint();
    }

    /// A place where there is no point.
    [[nodiscard]] QPoint beside(float x) const
    {
        if (const auto* area = qobject_cast<CurveArea*>(m_strip)) {
            return area->toScreen({x, 0.1F}).toPoint();
        }
        constexpr int kInTheBar = 8;
        constexpr double kMargin = 7.0;
        return {qRound(kMargin + (m_strip->width() - 2.0 * kMargin) * static_cast<double>(x)), kInTheBar};
    }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<Locks> m_locks;
    std::unique_ptr<ParameterRow> m_row;
    std::unique_ptr<QMenu> m_menu;
    PointStrip* m_strip = nullptr;
};

FUMAGE_TEST_MAIN(PointStripTest)
#include "point_strip_test.moc"
