#pragma once

#include "editor_helpers.h"

#include "ui/document/key_edits.h"
#include "ui/timeline/timeline_bar.h"

#include <QLayout>

#include <memory>

namespace fumage::tests {

/// The bar of the timeline over a document of its own for each test; without a window around it.
class TimelineFixture : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_document = std::make_unique<Document>();
        m_player = std::make_unique<Player>();
        m_bar = std::make_unique<TimelineBar>(*m_document, *m_player);
        prepare(*m_bar);
        m_bar->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_bar.get()));
    }
    void cleanup()
    {
        m_bar.reset();
        m_player.reset();
        m_document.reset();
    }

protected:
    /// Sets the bar up before it is shown.
    virtual void prepare(TimelineBar& bar) { bar.resize(900, 160); }

    void setTracks(const std::vector<Track>& tracks)
    {
        replaceTracks(*m_document, tracks, QStringLiteral("Set"));
        m_bar->layout()->activate();
        QCoreApplication::processEvents();
    }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<Player> m_player;
    std::unique_ptr<TimelineBar> m_bar;
};

} // namespace fumage::tests
