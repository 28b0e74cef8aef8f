#include "ui/viewport/viewport.h"

#include "ui/document/text.h"
#include "ui/preview/trails.h"
#include "ui/viewport/animation_overlay.h"
#include "ui/viewport/gizmo_painter.h"

#include "core/effect/known_parameter.h"
#include "core/simulation/air_plan.h"

#include <QPainter>
#include <QVBoxLayout>
#include <QWindow>

namespace fumage::ui {

Viewport::Viewport(
    Document& document, Solo& solo, Player& player, std::shared_ptr<AirCache> shelf, GlSupport support, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_solo(solo)
    , m_player(player)
    , m_feed(std::move(shelf))
    , m_surface(makeSurface(support, openGlIsWanted(), this, [this](QPainter& painter) { paintOverlays(painter); }))
    , m_hand(document, m_split, *m_surface->widget(), [this] { return view(); })
    , m_workLine(new WorkLine(this))
    , m_soloLine(new SoloLine(document, solo, this))
{
    setObjectName(QStringLiteral("viewport"));
    QWidget* surface = m_surface->widget();
    surface->setObjectName(QStringLiteral("viewport.surface"));
    surface->setAccessibleName(tr("Smoke"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(surface);

    m_feed.setSprites(m_surface->drawsSprites());
    m_feed.setScene(document.scene(), document.layer(), DirtyStage::Simulate, solo.layers());
    m_feed.setFrame(player.frame());
    m_feed.setPlaying(player.isPlaying());
    connect(&m_feed, &PreviewScheduler::ready, this, &Viewport::display);
    connect(&m_feed, &PreviewScheduler::otherReady, surface, qOverload<>(&QWidget::update));
    connect(&m_feed, &PreviewScheduler::cacheChanged, this, &Viewport::cacheChanged);
    connect(&m_feed, &PreviewScheduler::dropped, this, &Viewport::dropped);
    connect(&m_feed, &PreviewScheduler::working, this, &Viewport::followWork);
    connect(m_workLine, &WorkLine::stopped, this, &Viewport::stopWork);
    connect(m_workLine, &WorkLine::resumed, this, [this] {
        m_workLine->showStopped(false);
        m_feed.mayWork();
    });
    connect(m_workLine, &WorkLine::shownChanged, this, [this] {
        m_readout.restart(); // frames do not come as often as they did
        placeLines();
        m_surface->widget()->update();
    });
    connect(&m_feed, &PreviewScheduler::exhausted, this, &Viewport::exhausted);
    connect(&m_feed, &PreviewScheduler::failed, this, [this](const Error& why) { emit failed(translated(why)); });
    connect(&m_feed, &PreviewScheduler::waitingChanged, &m_player, &Player::setHeld);
    connect(&m_document, &Document::effectChanged, this, &Viewport::followDocument);
    connect(&m_document, &Document::autoKeyChanged, surface, qOverload<>(&QWidget::update));
    connect(&solo, &Solo::changed, this, [this] { m_feed.setSolo(m_solo.layers()); });
    connect(&m_document, &Document::loaded, this, &Viewport::startAnew);
    connect(&m_player, &Player::frameChanged, &m_feed, &PreviewScheduler::setFrame);
    connect(&m_player, &Player::playingChanged, &m_feed, &PreviewScheduler::setPlaying);
    connect(&m_player, &Player::playingChanged, this, [this] { m_readout.restart(); });
    connect(&m_hand, &ViewportInput::menuRequested, this, &Viewport::menuRequested);
    connect(&m_hand, &ViewportInput::clicked, this, &Viewport::click);
    connect(&m_feed, &PreviewScheduler::picked, this, [this](const std::optional<std::size_t>& layer) {
        if (layer) {
            choose(*layer);
        }
    });
}

View Viewport::view() const
{
    return windowView(m_document.scene(), m_player.frame(), std::max(1, width()), std::max(1, height()));
}

void Viewport::setOverlay(Overlay overlay, bool on)
{
    m_overlays.setFlag(overlay, on);
    m_hand.setGizmos(!m_isBare && m_overlays.testFlag(Overlay::Gizmos));
    if (overlay == Overlay::Trails) {
        m_feed.setTrails(on);
    } else if (overlay == Overlay::Air) {
        m_feed.setAir(on);
    }
    m_surface->widget()->update();
}

void Viewport::setCompare(Compare compare, const Scene& other)
{
    m_split.setMode(compare);
    m_feed.setOther(compare == Compare::Off ? std::nullopt : std::optional(other));
    m_surface->widget()->update();
}

void Viewport::followDocument(const EffectChange& change)
{
    if (!change.isOfScene) {
        m_feed.setLayer(m_document.layer());
        m_surface->widget()->update();
        return;
    }
    m_feed.setScene(m_document.scene(), m_document.layer(), change.stale, m_solo.layers());
    m_workLine->showStopped(m_feed.isStopped());
}

/// Nothing of one document is seen under the name of another, until there is a picture of that.
void Viewport::startAnew()
{
    m_feed.startAnew();
    m_surface->show(nullptr);
}

void Viewport::setBare(bool bare)
{
    m_isBare = bare;
    m_soloLine->setAway(bare);
    m_hand.setGizmos(!bare && m_overlays.testFlag(Overlay::Gizmos));
    m_surface->widget()->update();
}

void Viewport::followSize()
{
    m_feed.setSize((QSizeF(size()) * devicePixelRatioF()).toSize());
}

void Viewport::followVisibility()
{
    const bool isSeen = isVisible() && !window()->isMinimized();
    m_player.setSuspended(!isSeen);
    m_feed.setSeen(isSeen);
}

void Viewport::followWork(Phase phase, double share)
{
    emit baking(phase == Phase::Air ? share : 1.0);
    m_workLine->follow(phase, share);
    if (phase == Phase::Idle) {
        m_workLine->showStopped(m_feed.isStopped());
    }
    placeLines();
}

void Viewport::stopWork()
{
    m_feed.stopWork();
    m_workLine->showStopped(true);
}

/// What waits at the top, in the middle, and what is solo in the corner: nothing else is there.
void Viewport::placeLines()
{
    constexpr int kFromEdge = 12;
    m_workLine->move(std::max(0, (width() - m_workLine->width()) / 2), kFromEdge);
    m_soloLine->move(kFromEdge, kFromEdge);
}

void Viewport::display(const PicturePtr& picture)
{
    m_readout.count();
    m_surface->show(picture);
    emit pictureShown(picture);
}

void Viewport::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    placeLines();
    followSize();
}

void Viewport::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    window()->installEventFilter(this);
    // A screen of another scale has other pixels.
    connect(window()->windowHandle(), &QWindow::screenChanged, this, &Viewport::followSize, Qt::UniqueConnection);
    followSize();
    followVisibility();
}

void Viewport::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    followVisibility();
}

bool Viewport::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == window() && event->type() == QEvent::WindowStateChange) {
        followVisibility();
    }
    return QWidget::eventFilter(watched, event);
}

void Viewport::frameAll()
{
    glm::vec3 low = m_document.effect().emitter.position;
    glm::vec3 high = low;
    const Effect& effect = m_document.effect();
    const std::vector<SampledEffect> layers = sampledLayers(m_document.scene());
    const bool isAtHand = !effect.air.enabled || m_feed.shelf()->isBaked(layers, m_player.frame());
    if (!isAtHand) {
        const AirGrid grid = airGrid(layers); // where the smoke is expected
        m_document.moveCamera(framing(effect.camera, grid.corner, grid.end()));
        return;
    }
    for (const std::size_t layer : m_document.scene().visibleLayers()) {
        for (const Trail& trail : findTrails(m_document.scene(), layer, m_player.frame(), m_feed.shelf())) {
            if (!trail.empty()) {
                low = glm::min(low, trail.back());
                high = glm::max(high, trail.back());
            }
        }
    }
    m_document.moveCamera(framing(m_document.effect().camera, low, high));
}

QImage Viewport::shownPicture()
{
    // On a graphics card it is drawn there alone.
    return picture() && !picture()->image.isNull() ? picture()->image : surface()->grab().toImage();
}

void Viewport::resetCamera()
{
    m_document.moveCamera(m_document.reference().camera);
}

void Viewport::lookFrom(float yaw, float pitch)
{
    m_document.moveCamera(lookingFrom(m_document.effect().camera, yaw, pitch));
}

std::vector<std::size_t> Viewport::otherLayers() const
{
    std::vector<std::size_t> others = m_document.scene().visibleLayers();
    std::erase_if(others, [this](std::size_t layer) {
        return layer == m_document.layer() || (m_solo.isOn() && !m_solo.contains(layer));
    });
    return others;
}

Scene Viewport::sceneNow() const
{
    Scene now = m_document.scene();
    for (const std::size_t layer : otherLayers()) {
        now.layers[layer].emitter = now.effectAt(layer, m_document.seconds()).emitter;
    }
    return now;
}

void Viewport::choose(std::size_t layer)
{
    if (layer < m_document.scene().layers.size()) {
        m_document.selectLayers(
            m_picksMore ? LayerSelection(layer, m_document.selection().all()) : LayerSelection(layer));
    }
}

void Viewport::click(QPointF at, Qt::KeyboardModifiers modifiers)
{
    const bool isPlain = (modifiers & ~Qt::KeyboardModifiers(Qt::ControlModifier)) == Qt::NoModifier;
    if (m_document.scene().layers.size() < 2 || !isPlain || m_split.mode() != Compare::Off) {
        return;
    }
    m_picksMore = modifiers.testFlag(Qt::ControlModifier);
    const bool hasOutlines = !m_isBare && m_overlays.testFlag(Overlay::Emitter);
    if (const auto layer = hasOutlines ? emitterAt(sceneNow(), otherLayers(), view(), at) : std::nullopt) {
        choose(*layer);
        return;
    }
    m_feed.pick(
        {static_cast<float>(at.x() / std::max(1, width())), static_cast<float>(at.y() / std::max(1, height()))});
}

void Viewport::paintOverlays(QPainter& painter)
{
    if (otherPicture()) {
        m_split.paint(painter, otherPicture()->image, rect());
    }
    if (m_isBare) {
        return;
    }
    const View seen = view();
    const Effect& effect = m_document.effect();
    if (m_overlays.testFlag(Overlay::Grid)) {
        paintGrid(painter, seen);
    }
    // Handles come with the mouse: without it the smoke stands alone.
    const bool hasGizmos = m_overlays.testFlag(Overlay::Gizmos) && m_hand.isNear();
    const bool isAirTouched = hasGizmos && m_hand.gizmo() && isOfAir(*m_hand.gizmo());
    if (effect.air.enabled && (m_overlays.testFlag(Overlay::Air) || isAirTouched)) {
        paintAirBox(painter, m_document.scene(), seen);
    }
    if (effect.air.enabled && (m_overlays.testFlag(Overlay::Air) || hasGizmos)) {
        paintObstacle(painter, effect.air, seen);
    }
    if (m_overlays.testFlag(Overlay::Air) && picture()) {
        paintAir(painter, picture()->air, seen);
    }
    if (m_overlays.testFlag(Overlay::Trails) && picture()) {
        paintTrails(painter, picture()->trails, seen);
    }
    if (m_overlays.testFlag(Overlay::Emitter)) {
        paintOtherEmitters(painter, sceneNow(), otherLayers(), seen);
        paintEmitter(painter, effect.emitter, seen);
    }
    if (const Track* way = hasGizmos || m_overlays.testFlag(Overlay::Emitter)
            ? m_document.track(knownParameter("emitter.position"))
            : nullptr) {
        paintEmitterWay(painter, *way, effect.timeline, seen);
    }
    if (m_document.autoKey()) {
        paintAutoKey(painter, rect(), tr("Auto-key"));
    }
    if (hasGizmos) {
        paintGizmos(painter, effect, seen, m_hand.gizmo());
    }
    if (m_overlays.testFlag(Overlay::Frame)) {
        paintFrame(painter, exportFrame(m_document.scene(), width(), height()), rect(),
            QStringLiteral("%1 × %2").arg(effect.output.width).arg(effect.output.height));
    }
    if (m_overlays.testFlag(Overlay::Readout) && picture()) {
        m_readout.paint(painter, *picture(), m_player.isPlaying(), height());
    }
}

} // namespace fumage::ui
