// The tour: a bubble beside one control after another.
#include "editor_helpers.h"

#include "ui/shell/settings.h"
#include "ui/shell/tour.h"

#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

using namespace fumage;
using namespace fumage::tests;

class TourTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_window = std::make_unique<QMainWindow>();
        auto* centre = new QWidget;
        auto* layout = new QVBoxLayout(centre);
        for (const QString& name : {u"one"_q, u"two"_q, u"three"_q}) {
            auto* part = new QLineEdit(centre);
            part->setObjectName(name);
            layout->addWidget(part);
        }
        m_window->setCentralWidget(centre);
        m_dock = new QDockWidget(m_window.get());
        auto* inside = new QPushButton(m_dock);
        inside->setObjectName(u"docked"_q);
        m_dock->setWidget(inside);
        m_window->addDockWidget(Qt::LeftDockWidgetArea, m_dock);
        m_window->resize(900, 600);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }
    void cleanup() { m_window.reset(); }

    void itWalksThroughAllStepsAndBack()
    {
        const QPointer<Tour> tour = begin();
        for (const QString& name : {u"one"_q, u"docked"_q, u"two"_q, u"three"_q}) {
            QCOMPARE(tour->target()->objectName(), name);
            QCOMPARE(childOf<QLabel>(*tour, u"tour.text"_q)->text(), u"About "_q + name);
            QVERIFY(tour->isVisible());
            QVERIFY(m_window->rect().contains(tour->geometry()));
            const QRect control(tour->target()->mapTo(m_window.get(), QPoint()), tour->target()->size());
            QVERIFY(!control.intersects(tour->geometry()));
            if (name != u"three"_q) {
                childOf<QPushButton>(*tour, u"tour.next"_q)->click();
            }
        }
        QVERIFY(!childOf<QPushButton>(*tour, u"tour.next"_q)->isEnabled());
        for (const QString& name : {u"two"_q, u"docked"_q, u"one"_q}) {
            childOf<QPushButton>(*tour, u"tour.back"_q)->click();
            QCOMPARE(tour->target()->objectName(), name);
        }
        QVERIFY(!childOf<QPushButton>(*tour, u"tour.back"_q)->isEnabled());
        childOf<QPushButton>(*tour, u"tour.done"_q)->click();
        QTRY_VERIFY(tour.isNull());
    }

    void arrowsGoOnAndBackAndBeyondTheLastItEnds()
    {
        const QPointer<Tour> tour = begin();
        QTest::keyClick(tour, Qt::Key_Right);
        QTest::keyClick(tour, Qt::Key_Return);
        QCOMPARE(tour->target()->objectName(), u"two"_q);
        QTest::keyClick(tour, Qt::Key_Left);
        QCOMPARE(tour->target()->objectName(), u"docked"_q);
        QTest::keyClick(childOf<QPushButton>(*tour, u"tour.next"_q), Qt::Key_Right);
        QTest::keyClick(tour, Qt::Key_Right);
        QCOMPARE(tour->target()->objectName(), u"three"_q);
        QTest::keyClick(tour, Qt::Key_Right);
        QTRY_VERIFY(tour.isNull());
    }

    void escapeEndsIt()
    {
        const QPointer<Tour> tour = begin();
        QTest::keyClick(tour, Qt::Key_Escape);
        QTRY_VERIFY(tour.isNull());
    }

    void whatIsNotToBeSeenIsLeftOut()
    {
        m_dock->hide();
        const QPointer<Tour> tour = begin();
        tour->next();
        QCOMPARE(tour->target()->objectName(), u"two"_q);
        tour->back();
        QCOMPARE(tour->target()->objectName(), u"one"_q);
    }

    void whatTheBubbleCoversIsStillShown()
    {
        const QPointer<Tour> tour = begin();
        tour->setGeometry(m_window->rect());
        tour->next();
        QCOMPARE(tour->target()->objectName(), u"docked"_q);
    }

    void whatIsPutAwayMeanwhileIsLeft()
    {
        const QPointer<Tour> tour = begin();
        tour->next();
        QCOMPARE(tour->target()->objectName(), u"docked"_q);
        m_dock->hide();
        QTRY_COMPARE(tour->target()->objectName(), u"two"_q);
        delete m_window->findChild<QWidget*>(u"two"_q); // what it speaks of goes altogether
        tour->next();
        QCOMPARE(tour->target()->objectName(), u"three"_q);
    }

    void whereNothingIsToBeSeenThereIsNoTour()
    {
        m_window->centralWidget()->hide();
        m_dock->hide();
        QVERIFY(begin() == nullptr);
        QVERIFY(m_window->findChild<Tour*>() == nullptr);
    }

    void itIsCalledAgainAndThereIsOne()
    {
        const QPointer<Tour> first = begin();
        const QPointer<Tour> second = begin();
        QVERIFY(first.isNull() && !second.isNull());
        QCOMPARE(m_window->findChildren<Tour*>().size(), 1);
    }

    void allItsPartsHaveNames()
    {
        const Tour* tour = begin();
        QVERIFY(!tour->accessibleName().isEmpty());
        QCOMPARE(tour->accessibleDescription(), u"About one"_q);
        for (const QPushButton* button : tour->findChildren<QPushButton*>()) {
            QVERIFY2(!button->accessibleName().isEmpty(), qPrintable(button->objectName()));
        }
    }

    void itComesByItselfOnlyAtTheFirstUse()
    {
        Settings settings;
        QVERIFY(settings.isFirstUse());
        settings.setBytes(u"window/layout"_q, "x"); // somebody has closed a window
        QVERIFY(!settings.isFirstUse());
        QSettings(QSettings::IniFormat, QSettings::UserScope, u"fumage"_q, u"fumage"_q).remove(u"window/layout"_q);
        Settings again;
        QVERIFY(again.isFirstUse());
        again.setTourSeen();
        QVERIFY(!again.isFirstUse());
    }

private:
    /// A tour of four controls and one that is not there.
    Tour* begin()
    {
        std::vector<TourStep> steps;
        for (const QString& name : {u"one"_q, u"docked"_q, u"none"_q, u"two"_q, u"three"_q}) {
            steps.push_back({u"About "_q + name, [this, name] { return m_window->findChild<QWidget*>(name); }});
        }
        return Tour::start(*m_window, std::move(steps));
    }

    std::unique_ptr<QMainWindow> m_window;
    QDockWidget* m_dock = nullptr; ///< a child of the window
};

FUMAGE_TEST_MAIN(TourTest)
#include "tour_test.moc"
