#include "ui/timeline/emission_strip.h"

#include "ui/document/layer_edits.h"
#include "ui/timeline/timeline_ruler.h"
#include "ui/widgets/field_keys.h"
#include "ui/widgets/plain_text.h"

#include "core/simulation/schedule.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace fumage::ui {

namespace {

std::vector<float> sharesOf(const Scene& scene, std::size_t layer)
{
    const std::vector<std::int64_t> births =
        birthsOfFrames(makeSchedule(sampledLayer(scene, layer)), scene.timeline.length);
    const std::int64_t most = std::max<std::int64_t>(1, *std::ranges::max_element(births));
    std::vector<float> shares;
    for (const std::int64_t each : births) {
        shares.push_back(static_cast<float>(each) / static_cast<float>(most));
    }
    return shares;
}

/// Whether it emits as much at all times, but for the rounding to whole particles.
bool isEven(const std::vector<float>& shares)
{
    constexpr float kRounding = 0.8F;
    return *std::ranges::min_element(shares) > kRounding;
}

} // namespace

EmissionStrip::EmissionStrip(Document& document, const TimelineRuler& ruler, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_ruler(ruler)
{
    setObjectName(QStringLiteral("emissionStrip"));
    setAccessibleName(tr("Emission of the layers"));
    connect(&document, &Document::effectChanged, this, [this](const EffectChange& change) {
        if (change.stale >= DirtyStage::Simulate) {
            sync();
        }
    });
    connect(&document, &Document::layersChanged, this, &EmissionStrip::sync);
    connect(&document, &Document::selectionChanged, this, qOverload<>(&QWidget::update));
    sync();
    takeRoom();
}

void EmissionStrip::takeRoom()
{
    setFixedHeight(sizeHint().height());
    setVisible(!m_strips.empty());
}

QSize EmissionStrip::sizeHint() const
{
    return {400, kStripHeight * static_cast<int>(m_strips.size())};
}

void EmissionStrip::sync()
{
    const Scene& scene = m_document.scene();
    std::vector<Strip> now;
    for (const std::size_t layer : scene.visibleLayers()) {
        if (now.size() < kMaxStrips) {
            now.push_back({layer, sharesOf(scene, layer)});
        }
    }
    if (now.size() == 1 && isEven(now.front().shares)) {
        now.clear();
    }
    const bool isAsHigh = now.size() == m_strips.size();
    m_strips = std::move(now);
    if (!isAsHigh) {
        takeRoom();
        emit heightChanged();
    }
    update();
}

const EmissionStrip::Strip* EmissionStrip::stripAt(double y) const
{
    const auto strip = static_cast<std::size_t>(std::max(0.0, y) / kStripHeight);
    return strip < m_strips.size() ? &m_strips[strip] : nullptr;
}

bool EmissionStrip::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto& help = *static_cast<QHelpEvent*>(event);
        const Strip* strip = stripAt(help.pos().y());
        const QString name = strip != nullptr ? layerLabel(m_document.scene(), strip->layer) : QString();
        QToolTip::showText(
            help.globalPos(), plainToolTip(name.isEmpty() ? name : tr("Emission of %1").arg(name)), this);
        return true;
    }
    return QWidget::event(event);
}

void EmissionStrip::mousePressEvent(QMouseEvent* event)
{
    const Strip* strip = stripAt(event->position().y());
    if (event->button() == Qt::LeftButton && strip != nullptr) {
        const std::size_t layer = strip->layer; // the strips may be others in a moment
        leaveField(*this); // what is typed there is of the layer that was edited until now
        m_document.selectLayer(layer);
    }
}

void EmissionStrip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    for (std::size_t i = 0; i < m_strips.size(); ++i) {
        const Strip& strip = m_strips[i];
        const double top = static_cast<double>(i) * kStripHeight;
        QColor colour = strip.layer == m_document.layer() ? palette().highlight().color() : palette().text().color();
        colour.setAlpha(24);
        painter.fillRect(QRectF(0.0, top, width(), kStripHeight - 1.0), colour);
        const double frame = m_ruler.xOf(1.0) - m_ruler.xOf(0.0);
        for (std::size_t k = 0; k < strip.shares.size(); ++k) {
            constexpr int kOpaque = 200;
            colour.setAlpha(static_cast<int>(std::lround(kOpaque * strip.shares[k])));
            const double left = m_ruler.xOf(static_cast<double>(k));
            painter.fillRect(QRectF(left, top, std::max(1.0, frame), kStripHeight - 1.0), colour);
        }
    }
}

} // namespace fumage::ui
