#include "ui/viewport/viewport.h"

#include "ui/pictures/tracks.h"

#include <cmath>

#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <QWindow>

namespace fumage::ui {

namespace {

constexpr double kDividerReach = 8.0;

} // namespace

Viewport::Viewport(Document& document, Player& player, GlSupport support, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_player(player)
    , m_surface(makeSurface(support, openGlIsWanted(), this, [this](QPainter& painter) { paintOverlay(painter); }))
{
    setObjectName(QStringLiteral("viewport"));
    QWidget* surface = m_surface->widget();
    surface->setObjectName(QStringLiteral("viewport.surface"));
    surface->setAccessibleName(tr("Smoke"));
    surface->setFocusPolicy(Qt::StrongFocus);
    surface->setMouseTracking(true);
    surface->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(surface);

    m_feed.setSprites(m_surface->drawsSprites());
    m_feed.setEffect(document.effect(), Stage::Simulate);
    m_feed.setFrame(player.frame());
    m_feed.setPlaying(player.isPlaying());
    connect(&m_feed, &PictureFeed::ready, this, &Viewport::display);
    connect(&m_feed, &PictureFeed::otherReady, surface, qOverload<>(&QWidget::update));
    connect(&m_feed, &PictureFeed::cacheChanged, this, &Viewport::cacheChanged);
    connect(&m_feed, &PictureFeed::waitingChanged, &m_player, &Player::setHeld);
    connect(&m_document, &Document::effectChanged, this, &Viewport::followDocument);
    connect(&m_player, &Player::frameChanged, &m_feed, &PictureFeed::setFrame);
    connect(&m_player, &Player::playingChanged, &m_feed, &PictureFeed::setPlaying);
    connect(&m_player, &Player::playingChanged, this, [this] { m_frameMs = 0.0; });
    connect(&m_wheelBurst, &Burst::timeout, this, [this] { m_wheelGesture = {}; });
}

Viewport::~Viewport()
{
    // A surface that goes sends events, which must not ask for the surface any more.
    m_surface->widget()->removeEventFilter(this);
    window()->removeEventFilter(this);
}

View Viewport::view() const
{
    return windowView(m_document.effect(), m_player.frame(), std::max(1, width()), std::max(1, height()));
}

void Viewport::setOverlay(Overlay overlay, bool on)
{
    m_overlays.setFlag(overlay, on);
    if (overlay == Overlay::Tracks) {
        m_feed.setTracks(on);
    }
    m_surface->widget()->update();
}

void Viewport::setCompare(Compare compare, const Effect& other)
{
    m_compare = compare;
    m_feed.setOther(compare == Compare::Off ? std::nullopt : std::optional(other));
    m_surface->widget()->update();
}

// --- pictures ------------------------------------------------------------------------------------------------------------

void Viewport::followDocument(const EffectChange& change)
{
    m_feed.setEffect(m_document.effect(), change.stale);
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

void Viewport::display(const PicturePtr& picture)
{
    if (m_sinceShown.isValid()) {
        constexpr double kShareOfNewest = 0.15;
        constexpr double kNanosecondsAMillisecond = 1e6;
        const double ms = static_cast<double>(m_sinceShown.nsecsElapsed()) / kNanosecondsAMillisecond;
        m_frameMs = m_frameMs == 0.0 ? ms : m_frameMs + (ms - m_frameMs) * kShareOfNewest;
    }
    m_sinceShown.start();
    m_surface->show(picture);
    emit pictureShown(picture);
}

void Viewport::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
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

// --- camera --------------------------------------------------------------------------------------------------------------

void Viewport::applyCamera(const Camera& camera, const QString& text, Gesture gesture)
{
    m_document.edit(assignmentsOf(camera), text, gesture);
}

void Viewport::frameAll()
{
    glm::vec3 low = m_document.effect().emitter.position;
    glm::vec3 high = low;
    const std::vector<Track> tracks = findTracks(m_document.effect(), m_player.frame());
    for (const Track& track : tracks) {
        if (!track.empty()) {
            low = glm::min(low, track.back());
            high = glm::max(high, track.back());
        }
    }
    applyCamera(framing(m_document.effect().camera, low, high), tr("Frame all"), {});
}

void Viewport::lookFrom(float yaw, float pitch)
{
    applyCamera(lookingFrom(m_document.effect().camera, yaw, pitch), tr("Change view"), {});
}

// --- mouse ---------------------------------------------------------------------------------------------------------------

bool Viewport::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == window() && event->type() == QEvent::WindowStateChange) {
        followVisibility();
    }
    if (watched != m_surface->widget()) {
        return false;
    }
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        press(static_cast<QMouseEvent&>(*event));
        return true;
    case QEvent::MouseMove:
        move(static_cast<QMouseEvent&>(*event));
        return true;
    case QEvent::MouseButtonRelease:
        release();
        return true;
    case QEvent::Wheel:
        wheel(static_cast<QWheelEvent&>(*event));
        return true;
    case QEvent::Leave:
        setHot(std::nullopt);
        return false;
    default:
        return false;
    }
}

double Viewport::dividerX() const
{
    return m_divider * width();
}

void Viewport::press(QMouseEvent& event)
{
    m_surface->widget()->setFocus(Qt::MouseFocusReason);
    Drag drag;
    drag.start = event.position();
    drag.before = m_document.effect();
    drag.view = view();
    if (event.button() == Qt::LeftButton && m_compare == Compare::Split && std::abs(event.position().x() - dividerX()) < kDividerReach) {
        drag.divider = true;
    } else if (event.button() == Qt::LeftButton && m_overlays.testFlag(Overlay::Gizmos) && !event.modifiers().testFlag(Qt::AltModifier)) {
        drag.gizmo = gizmoAt(m_document.effect(), drag.view, event.position());
    }
    if (!drag.gizmo && !drag.divider) {
        drag.move = cameraMoveFor(m_style, event.button(), event.modifiers());
        if (!drag.move) {
            return;
        }
    }
    drag.gesture = m_document.beginGesture();
    m_drag = drag;
}

void Viewport::move(QMouseEvent& event)
{
    if (!m_drag) {
        setHot(m_overlays.testFlag(Overlay::Gizmos) ? gizmoAt(m_document.effect(), view(), event.position()) : std::nullopt);
        return;
    }
    const Drag& drag = *m_drag;
    const QPointF way = event.position() - drag.start;
    if (drag.divider) {
        m_divider = std::clamp(event.position().x() / std::max(1, width()), 0.02, 0.98);
        m_surface->widget()->update();
    } else if (drag.gizmo) {
        m_document.edit(dragGizmo(*drag.gizmo, drag.before, drag.view, event.position(), event.modifiers().testFlag(Qt::ControlModifier)), {}, drag.gesture);
    } else if (drag.move == CameraMove::Orbit) {
        applyCamera(orbited(drag.before.camera, way, drag.view), tr("Orbit"), drag.gesture);
    } else if (drag.move == CameraMove::Pan) {
        applyCamera(panned(drag.before.camera, way, drag.view), tr("Pan"), drag.gesture);
    } else {
        constexpr double kNotchesAPixel = 0.03;
        applyCamera(zoomed(drag.before.camera, -way.y() * kNotchesAPixel, drag.view), tr("Zoom"), drag.gesture);
    }
}

void Viewport::release()
{
    m_drag.reset();
}

void Viewport::wheel(QWheelEvent& event)
{
    if (m_drag || event.angleDelta().y() == 0) {
        return;
    }
    if (m_wheelGesture.id == 0) {
        m_wheelGesture = m_document.beginGesture();
    }
    m_wheelBurst.start();
    applyCamera(zoomed(m_document.effect().camera, notchesOf(event), view()), tr("Zoom"), m_wheelGesture);
}

void Viewport::setHot(std::optional<GizmoId> gizmo)
{
    if (gizmo != m_hot) {
        m_hot = gizmo;
        m_surface->widget()->setCursor(gizmo ? Qt::OpenHandCursor : Qt::ArrowCursor);
        m_surface->widget()->update();
    }
}

// --- paint ---------------------------------------------------------------------------------------------------------------

void Viewport::paintOther(QPainter& painter)
{
    if (m_compare == Compare::Off || !otherPicture()) {
        return;
    }
    const double left = m_compare == Compare::Split ? dividerX() : 0.0;
    painter.save();
    painter.setClipRect(QRectF(left, 0.0, width() - left, height()));
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(rect(), otherPicture()->image);
    painter.restore();
    if (m_compare == Compare::Split) {
        painter.setPen(QPen(QColor(255, 255, 255, 200), 2.0));
        painter.drawLine(QLineF(left, 0.0, left, height()));
        painter.drawText(QRectF(left - 28.0, 10.0, 20.0, 20.0), Qt::AlignCenter, QStringLiteral("A"));
    }
    painter.setPen(QColor(255, 255, 255, 220));
    painter.drawText(QRectF(left + 8.0, 10.0, 20.0, 20.0), Qt::AlignCenter, QStringLiteral("B"));
}

void Viewport::paintReadout(QPainter& painter) const
{
    if (!picture()) {
        return;
    }
    const auto ms = [](std::chrono::nanoseconds time) { return QString::number(std::chrono::duration<double, std::milli>(time).count(), 'f', 1); };
    QStringList lines;
    if (m_player.isPlaying() && m_frameMs > 0.0) {
        lines += tr("%1 frames/s").arg(1000.0 / m_frameMs, 0, 'f', 0);
    }
    lines += tr("%L1 particles").arg(picture()->particles);
    lines += tr("step %1 ms").arg(ms(std::chrono::nanoseconds(picture()->stepNs)));
    lines += tr("light %1 ms").arg(ms(picture()->times.light + picture()->times.sprites));
    lines += tr("composite %1 ms").arg(ms(picture()->times.composite));
    const QString text = lines.join(QStringLiteral("   "));
    painter.setPen(QColor(0, 0, 0, 170));
    painter.drawText(QPointF(13.0, height() - 11.0), text);
    painter.setPen(QColor(225, 230, 238, 200));
    painter.drawText(QPointF(12.0, height() - 12.0), text);
}

void Viewport::paintOverlay(QPainter& painter)
{
    paintOther(painter);
    const View seen = view();
    const Effect& effect = m_document.effect();
    if (m_overlays.testFlag(Overlay::Grid)) {
        paintGrid(painter, seen);
    }
    if (m_overlays.testFlag(Overlay::Tracks) && picture()) {
        paintTracks(painter, picture()->tracks, seen);
    }
    if (m_overlays.testFlag(Overlay::Emitter)) {
        paintEmitter(painter, effect.emitter, seen);
    }
    if (m_overlays.testFlag(Overlay::Gizmos)) {
        paintGizmos(painter, effect, seen, m_drag ? m_drag->gizmo : m_hot);
    }
    if (m_overlays.testFlag(Overlay::Frame)) {
        paintFrame(painter, exportFrame(effect, width(), height()), rect(), QStringLiteral("%1 × %2").arg(effect.output.width).arg(effect.output.height));
    }
    if (m_overlays.testFlag(Overlay::Readout)) {
        paintReadout(painter);
    }
}

} // namespace fumage::ui
