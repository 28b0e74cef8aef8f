#include "ui/timeline/timeline_bar.h"

#include "ui/document/number_text.h"
#include "ui/document/parameter_text.h"
#include "ui/widgets/field_keys.h"
#include "ui/widgets/gesture.h"
#include "ui/theme/icons.h"
#include "ui/panels/whole_box.h"

#include "core/effect/known_parameter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr const Parameter& kFrameRate = knownParameter("timeline.frame_rate");
constexpr const Parameter& kLoop = knownParameter("timeline.loop");

} // namespace

TimelineBar::TimelineBar(Document& document, Player& player, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_player(player)
    , m_controls(new QHBoxLayout)
    , m_ruler(new TimelineRuler(player, this))
    , m_markers(new MarkerLane(document, player, *m_ruler, this))
    , m_emission(new EmissionStrip(document, *m_ruler, this))
    , m_keys(new KeySelection(document, this))
    , m_lanes(new KeyLanes(document, player, *m_ruler, *m_keys, this))
    , m_lanesView(new QScrollArea(this))
    , m_grip(new GraphGrip(this))
    , m_graph(new KeyGraph(document, player, *m_ruler, *m_keys, this))
    , m_frame(new WholeBox(this))
    , m_time(new QLabel(this))
{
    setObjectName(QStringLiteral("timeline"));
    m_controls->setSpacing(2);
    addButtons(*m_controls);
    addFrameAndTime(*m_controls);
    addLoop(*m_controls);
    addSpeedAndRate(*m_controls);
    addMore(*m_controls);
    auto* layout = new QVBoxLayout(this);
    layout->setSizeConstraint(QLayout::SetNoConstraint); // minimumSizeHint() says what is needed
    layout->setContentsMargins(8, 4, 8, 6);
    layout->setSpacing(4);
    layout->addLayout(m_controls);
    layout->addWidget(m_markers);
    layout->addWidget(m_ruler);
    layout->addWidget(m_emission);
    addLanes(*layout);
    connectPlayer();
    connect(m_markers, &MarkerLane::heightChanged, this, [this] { updateGeometry(); });
    connect(m_emission, &EmissionStrip::heightChanged, this, [this] { updateGeometry(); });
    connect(&document, &Document::effectChanged, this, &TimelineBar::followDocument);
    followDocument();
}

void TimelineBar::addLanes(QVBoxLayout& layout)
{
    m_lanesView->setObjectName(QStringLiteral("keyLanesView"));
    m_lanesView->setFrameShape(QFrame::NoFrame);
    m_lanesView->setWidget(m_lanes);
    m_lanesView->setWidgetResizable(true);
    m_lanesView->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    layout.addWidget(m_lanesView);
    layout.addWidget(m_grip);
    layout.addWidget(m_graph);
    connect(m_lanes, &KeyLanes::heightChanged, this, &TimelineBar::showLanes);
    connectGrip();
    showLanes();
}

void TimelineBar::connectGrip()
{
    connect(m_grip, &GraphGrip::pressed, this, [this] { m_pressedHeight = graphHeight(); });
    connect(m_grip, &GraphGrip::dragged, this, [this](int way) { setGraphHeight(m_pressedHeight - way); });
    connect(m_grip, &GraphGrip::doubleClicked, this, [this] { setGraphHeight(KeyGraph::kHeight); });
}

int TimelineBar::graphHeight() const
{
    return m_graph->maximumHeight(); // it is a fixed one
}

void TimelineBar::setGraphHeight(int height)
{
    const int inside = std::clamp(height, KeyGraph::kMinHeight, KeyGraph::kMaxHeight);
    if (inside != graphHeight()) {
        m_graph->setFixedHeight(inside);
        updateGeometry();
        emit graphHeightChanged(inside);
    }
}

void TimelineBar::showLanes()
{
    constexpr int kAlone = 6;
    constexpr int kAboveTheGraph = 4;
    const int height = m_lanes->sizeHint().height();
    const int shown = m_showsGraph ? kAboveTheGraph : kAlone;
    m_lanesView->setFixedHeight(std::min(height, shown * KeyLanes::kLaneHeight));
    m_lanesView->setVisible(height > 0);
    m_lanes->setMarksShown(m_showsGraph);
    m_grip->setVisible(height > 0 && m_showsGraph);
    m_graph->setVisible(height > 0 && m_showsGraph);
    updateGeometry();
}

void TimelineBar::setShowsGraph(bool shows)
{
    if (shows == m_showsGraph) {
        return;
    }
    m_showsGraph = shows;
    m_graphButton->setChecked(shows);
    showLanes();
    emit graphToggled(shows);
}

void TimelineBar::addButtons(QHBoxLayout& controls)
{
    QToolButton* start =
        makeIconButton(this, QStringLiteral("toStart"), QStringLiteral("to-start"), tr("Go to start (Home)"));
    QToolButton* back =
        makeIconButton(this, QStringLiteral("stepBack"), QStringLiteral("step-back"), tr("Previous frame (Left)"));
    m_play = makeIconButton(this, QStringLiteral("playButton"), QStringLiteral("play"), tr("Play or pause (Space)"));
    QToolButton* forward =
        makeIconButton(this, QStringLiteral("stepForward"), QStringLiteral("step-forward"), tr("Next frame (Right)"));
    QToolButton* end = makeIconButton(this, QStringLiteral("toEnd"), QStringLiteral("to-end"), tr("Go to end (End)"));
    m_repeat = makeIconButton(this, QStringLiteral("repeat"), QStringLiteral("loop"),
        tr("Repeat playback: start again after the last frame, whether it fits the first or not"));
    m_repeat->setCheckable(true);
    m_graphButton = makeIconButton(this, QStringLiteral("graphButton"), QStringLiteral("graph"),
        tr("Show the curves of key frames in a graph (Shift+G)"));
    m_graphButton->setCheckable(true);
    for (QToolButton* button : {start, back, m_play, forward, end, m_repeat, m_graphButton}) {
        controls.addWidget(button);
    }
    connect(start, &QToolButton::clicked, &m_player, &Player::toStart);
    connect(back, &QToolButton::clicked, this, [this] { m_player.stepBy(-1); });
    connect(forward, &QToolButton::clicked, this, [this] { m_player.stepBy(1); });
    connect(end, &QToolButton::clicked, &m_player, &Player::toEnd);
}

void TimelineBar::addFrameAndTime(QHBoxLayout& controls)
{
    m_frame->setObjectName(QStringLiteral("frameField"));
    m_frame->setAccessibleName(tr("Frame"));
    m_frame->setToolTip(tr("The frame that is shown"));
    m_frame->setKeyboardTracking(false);
    new SpinBoxKeys(*m_frame);
    m_time->setProperty("role", QStringLiteral("secondary"));
    controls.addSpacing(8);
    controls.addWidget(m_frame);
    controls.addWidget(m_time, 1);
}

void TimelineBar::addLoop(QHBoxLayout& controls)
{
    m_loop = new QCheckBox(labelOf(kLoop), this);
    m_loop->setObjectName(QStringLiteral("seamlessLoop"));
    m_loop->setToolTip(toolTipOf(kLoop));
    controls.addWidget(m_loop);
    controls.addSpacing(8);
    connect(m_loop, &QCheckBox::clicked, this, [this](bool on) { m_document.edit(kLoop, on); });
}

void TimelineBar::addSpeedAndRate(QHBoxLayout& controls)
{
    m_speed = new QComboBox(this);
    m_speed->setObjectName(QStringLiteral("playSpeed"));
    m_speed->setAccessibleName(tr("Speed"));
    m_speed->setToolTip(tr("Speed of playing"));
    for (const double factor : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0}) {
        m_speed->addItem(formatNumber(factor) + QStringLiteral("×"), factor);
    }
    m_speed->setCurrentIndex(m_speed->findData(1.0));
    m_rate = new WholeBox(this);
    m_rate->setObjectName(QStringLiteral("frameRateField"));
    m_rate->setAccessibleName(tr("Frames per second"));
    m_rate->setToolTip(tr("Frames per second of the effect"));
    m_rate->setKeyboardTracking(false);
    m_rate->setRange(static_cast<int>(kFrameRate.hard.low), static_cast<int>(kFrameRate.hard.high));
    m_rate->setSuffix(tr(" fps"));
    new SpinBoxKeys(*m_rate);
    controls.addWidget(m_speed);
    controls.addWidget(m_rate);
}

void TimelineBar::addMore(QHBoxLayout& controls)
{
    m_more = new QToolButton(this);
    m_more->setObjectName(QStringLiteral("moreControls"));
    m_more->setText(QStringLiteral("⋯"));
    m_more->setAutoRaise(true);
    m_more->setToolTip(tr("What there is no room for"));
    m_more->setAccessibleName(m_more->toolTip());
    m_more->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(m_more);
    menu->setObjectName(QStringLiteral("moreControls.menu"));
    m_more->setMenu(menu);
    controls.addWidget(m_more);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillMore(*menu); });
}

void TimelineBar::fillMore(QMenu& menu)
{
    menu.clear();
    const auto addChoice = [](QMenu& to, const QString& text, bool chosen, const std::function<void()>& choose) {
        QAction* action = to.addAction(text, choose);
        action->setCheckable(true);
        action->setChecked(chosen);
    };
    if (m_repeat->isHidden()) {
        addChoice(menu, m_repeat->toolTip(), m_repeat->isChecked(), [this] { m_repeat->click(); });
    }
    if (m_graphButton->isHidden()) {
        addChoice(menu, m_graphButton->toolTip(), m_showsGraph, [this] { setShowsGraph(!m_showsGraph); });
    }
    if (m_loop->isHidden()) {
        addChoice(menu, m_loop->text(), m_loop->isChecked(), [this] { m_loop->click(); });
    }
    if (m_speed->isHidden()) {
        QMenu* speeds = menu.addMenu(m_speed->toolTip());
        for (int i = 0; i < m_speed->count(); ++i) {
            addChoice(*speeds, m_speed->itemText(i), i == m_speed->currentIndex(),
                [this, i] { m_speed->setCurrentIndex(i); });
        }
    }
    if (m_rate->isHidden()) {
        QMenu* rates = menu.addMenu(m_rate->toolTip());
        std::set<int> offered{12, 15, 24, 25, 30, 48, 50, 60, 120};
        offered.insert(m_rate->value());
        for (const int rate : offered) {
            addChoice(*rates, QString::number(rate), rate == m_rate->value(), [this, rate] { m_rate->setValue(rate); });
        }
    }
}

void TimelineBar::connectPlayer()
{
    connect(m_play, &QToolButton::clicked, &m_player, &Player::toggle);
    connect(m_repeat, &QToolButton::toggled, &m_player, &Player::setRepeats);
    connect(m_graphButton, &QToolButton::toggled, this, &TimelineBar::setShowsGraph);
    connect(m_speed, &QComboBox::currentIndexChanged, this,
        [this] { m_player.setSpeed(m_speed->currentData().toDouble()); });
    connect(m_frame, &QSpinBox::valueChanged, &m_player, &Player::setFrame);
    connect(m_rate, &QSpinBox::valueChanged, this, [this](int value) { m_document.edit(kFrameRate, value); });
    connect(&m_player, &Player::frameChanged, this, &TimelineBar::showTime);
    connect(&m_player, &Player::frameChanged, this, &TimelineBar::tellTime);
    connect(&m_player, &Player::settingsChanged, this, &TimelineBar::sync);
    connect(&m_player, &Player::playingChanged, this, &TimelineBar::sync);
}

void TimelineBar::followDocument()
{
    const Timeline& timeline = m_document.effect().timeline;
    const QSignalBlocker blocker(m_rate);
    m_rate->setValue(timeline.frameRate);
    m_loop->setChecked(timeline.loop);
    m_player.setTimeline(timeline.length, timeline.frameRate);
    tellTime();
    sync();
}

void TimelineBar::tellTime()
{
    m_document.setSeconds(static_cast<double>(m_player.frame()) / m_document.scene().timeline.frameRate);
}

std::array<QWidget*, 6> TimelineBar::dispensable() const
{
    return {m_rate, m_speed, m_time, m_loop, m_graphButton, m_repeat};
}

QSize TimelineBar::minimumSizeHint() const
{
    int needed = QWidget::minimumSizeHint().width();
    needed += m_more->isHidden() ? m_more->sizeHint().width() + m_controls->spacing() : 0;
    for (const QWidget* first : dispensable()) {
        needed -= first->isHidden() ? 0 : first->minimumSizeHint().width() + m_controls->spacing();
    }
    return {needed, QWidget::minimumSizeHint().height()};
}

void TimelineBar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    hideOverflow();
}

/// On a small screen some controls go, rather than that all are cut off.
void TimelineBar::hideOverflow()
{
    const QMargins margins = layout()->contentsMargins();
    int needed = margins.left() + margins.right();
    for (int i = 0; i < m_controls->count(); ++i) {
        const QLayoutItem& item = *m_controls->itemAt(i);
        needed += m_controls->spacing()
            + (item.widget() != nullptr ? item.widget()->sizeHint().width() : item.sizeHint().width());
    }
    const int more = m_more->sizeHint().width() + m_controls->spacing();
    needed -= more;
    const bool all = needed <= width();
    needed += all ? 0 : more;
    for (QWidget* first : dispensable()) {
        const bool fits = needed <= width();
        first->setVisible(fits);
        needed -= fits ? 0 : first->sizeHint().width() + m_controls->spacing();
    }
    m_more->setVisible(!all);
}

void TimelineBar::sync()
{
    m_play->setIcon(themedIcon(m_player.isPlaying() ? QStringLiteral("pause") : QStringLiteral("play")));
    const QSignalBlocker repeatBlocker(m_repeat);
    const QSignalBlocker frameBlocker(m_frame);
    m_repeat->setChecked(m_player.repeats());
    m_frame->setRange(0, m_player.length() - 1);
    m_frame->setSuffix(tr(" of %1").arg(m_player.length() - 1));
    showTime();
    hideOverflow(); // the field may be wider now
}

void TimelineBar::showTime()
{
    const QSignalBlocker blocker(m_frame);
    m_frame->setValue(m_player.frame());
    m_time->setText(
        tr("%1 s").arg(formatFixed(static_cast<double>(m_player.frame()) / m_document.effect().timeline.frameRate, 2)));
}

} // namespace fumage::ui
