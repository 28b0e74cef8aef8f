#pragma once

#include "ui/document/document.h"
#include "ui/timeline/emission_strip.h"
#include "ui/timeline/graph_grip.h"
#include "ui/timeline/key_graph.h"
#include "ui/timeline/key_lanes.h"
#include "ui/timeline/marker_lane.h"
#include "ui/timeline/player.h"
#include "ui/timeline/timeline_ruler.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QMenu;
class QScrollArea;
class QSpinBox;
class QToolButton;
class QVBoxLayout;

namespace fumage::ui {

/// Play, step, scrub, range, repeat, seamless loop, speed and frame rate, and what changes over time: lanes of key
/// frames, and a graph of the curves of those that are chosen there.
class TimelineBar : public QWidget {
    Q_OBJECT

public:
    TimelineBar(Document& document, Player& player, QWidget* parent = nullptr);

    [[nodiscard]] TimelineRuler& ruler() const { return *m_ruler; }
    [[nodiscard]] KeyLanes& lanes() const { return *m_lanes; }
    [[nodiscard]] MarkerLane& markers() const { return *m_markers; }
    [[nodiscard]] EmissionStrip& emission() const { return *m_emission; }
    [[nodiscard]] KeyGraph& graph() const { return *m_graph; }

    /// Whether the graph is shown, as soon as something changes over time.
    [[nodiscard]] bool showsGraph() const { return m_showsGraph; }
    void setShowsGraph(bool shows);
    /// How high the graph is where it is shown, pixels.
    [[nodiscard]] int graphHeight() const;
    /// @param height that is brought into KeyGraph::kMinHeight to KeyGraph::kMaxHeight
    void setGraphHeight(int height);

    QSize minimumSizeHint() const override;

signals:
    void graphToggled(bool shows);
    void graphHeightChanged(int height);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void hideOverflow();
    /// What goes on a narrow screen, the first of them first.
    [[nodiscard]] std::array<QWidget*, 6> dispensable() const;
    void addLanes(QVBoxLayout& layout);
    void connectGrip();
    void showLanes();
    void addButtons(QHBoxLayout& controls);
    void addFrameAndTime(QHBoxLayout& controls);
    void addLoop(QHBoxLayout& controls);
    void addSpeedAndRate(QHBoxLayout& controls);
    void addMore(QHBoxLayout& controls);
    /// What the bar has no room for.
    void fillMore(QMenu& menu);
    void connectPlayer();
    void followDocument();
    void sync();
    void showTime();
    /// Edits put key frames at the frame that is shown.
    void tellTime();

    Document& m_document;
    Player& m_player;
    QHBoxLayout* m_controls;
    TimelineRuler* m_ruler;
    MarkerLane* m_markers;
    EmissionStrip* m_emission;
    KeySelection* m_keys; ///< of lanes and graph
    KeyLanes* m_lanes;
    QScrollArea* m_lanesView; ///< shows a few of them, and scrolls
    GraphGrip* m_grip; ///< over the graph
    KeyGraph* m_graph;
    int m_pressedHeight = 0; ///< of the graph, when the grip was pressed
    bool m_showsGraph = false;
    QToolButton* m_play;
    QToolButton* m_repeat;
    QToolButton* m_graphButton;
    QToolButton* m_more; ///< there while something is hidden
    QCheckBox* m_loop; ///< a parameter of the document
    QSpinBox* m_frame;
    QLabel* m_time;
    QComboBox* m_speed;
    QSpinBox* m_rate;
};

} // namespace fumage::ui
