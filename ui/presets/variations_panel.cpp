#include "ui/presets/variations_panel.h"

#include "ui/theme/icons.h"

#include "core/effect/parameter_table.h"
#include "core/effect/variation.h"

#include <algorithm>
#include <cmath>

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QRandomGenerator>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kMinEdge = 88;
constexpr int kLargestEdge = 256;
constexpr int kAttempts = 5; ///< for a cell; the last goes a 16th of the way
constexpr int kLargestAmount = 40; ///< percent of the soft range
constexpr int kUsualAmount = 10;
constexpr int kColumns = 3;
constexpr int kAround = 16; // a picture: frame and gap
constexpr int kOther = 110; // above and below all of them

} // namespace

VariationsPanel::VariationsPanel(Document& document, Locks& locks, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_locks(locks)
    , m_amount(new QSlider(Qt::Horizontal, this))
    , m_back(new QToolButton(this))
    , m_locked(new QLabel(this))
{
    setObjectName(QStringLiteral("variations"));
    m_locked->setProperty("role", QStringLiteral("secondary"));
    m_locked->setWordWrap(true);
    QGridLayout* grid = makeGrid();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addLayout(makeBar());
    layout->addLayout(grid);
    layout->addWidget(m_locked);
    layout->addStretch();
    connectParts();
}

QGridLayout* VariationsPanel::makeGrid()
{
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    for (int i = 0; i < kCells; ++i) {
        auto* cell = new QToolButton(this);
        cell->setObjectName(QStringLiteral("variation.%1").arg(i));
        cell->setAccessibleName(i == kMiddle ? tr("The present smoke") : tr("Variation %1").arg(i + 1));
        cell->setToolTip(i == kMiddle ? tr("The smoke as it is") : tr("Click to adopt this variation"));
        cell->setCheckable(i == kMiddle);
        cell->setChecked(i == kMiddle);
        m_cells[static_cast<std::size_t>(i)] = cell;
        grid->addWidget(cell, i / kColumns, i % kColumns, Qt::AlignCenter);
        connect(cell, &QToolButton::clicked, this, [this, i] { adopt(i); });
    }
    return grid;
}

QHBoxLayout* VariationsPanel::makeBar()
{
    m_back->setObjectName(QStringLiteral("variations.back"));
    m_back->setIcon(themedIcon(QStringLiteral("back")));
    m_back->setToolTip(tr("Previous variation"));
    m_back->setAccessibleName(m_back->toolTip());
    auto* dice = new QToolButton(this);
    dice->setObjectName(QStringLiteral("variations.dice"));
    dice->setIcon(themedIcon(QStringLiteral("dice")));
    dice->setToolTip(tr("Other variations"));
    dice->setAccessibleName(dice->toolTip());
    connect(dice, &QToolButton::clicked, this, &VariationsPanel::throwDice);
    m_amount->setObjectName(QStringLiteral("variations.amount"));
    m_amount->setAccessibleName(tr("How far they differ"));
    m_amount->setToolTip(tr("How far they differ"));
    m_amount->setRange(1, kLargestAmount);
    m_amount->setValue(kUsualAmount);
    auto* bar = new QHBoxLayout;
    bar->addWidget(m_back);
    bar->addWidget(dice);
    bar->addWidget(new QLabel(tr("Subtle"), this));
    bar->addWidget(m_amount, 1);
    bar->addWidget(new QLabel(tr("Wild"), this));
    return bar;
}

void VariationsPanel::connectParts()
{
    constexpr int kSettleMs = 200;
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettleMs);
    connect(&m_settle, &QTimer::timeout, this, &VariationsPanel::fill);
    connect(m_back, &QToolButton::clicked, this, &VariationsPanel::goBack);
    connect(m_amount, &QSlider::valueChanged, this, &VariationsPanel::fill);
    connect(&m_locks, &Locks::changed, this, &VariationsPanel::fill);
    connect(&m_thumbnailer, &Thumbnailer::ready, this, &VariationsPanel::receive);
    connect(&m_document, &Document::effectChanged, this, &VariationsPanel::follow);
    connect(&m_document, &Document::loaded, this, [this] { m_lineage.clear(); });
}

QSize VariationsPanel::minimumSizeHint() const
{
    return {kColumns * (kMinEdge + kAround) + kAround, kColumns * (kMinEdge + kAround) + kOther};
}

void VariationsPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    fill();
}

void VariationsPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const int edge = std::clamp(
        std::min((width() - kAround) / kColumns, (height() - kOther) / kColumns) - kAround, kMinEdge, kLargestEdge);
    if (edge == m_edge) {
        return;
    }
    m_edge = edge;
    for (QToolButton* cell : m_cells) {
        cell->setIconSize({edge, edge});
    }
    m_settle.start();
}

int VariationsPanel::thumbnailEdge() const
{
    return static_cast<int>(m_edge * devicePixelRatioF());
}

void VariationsPanel::throwDice()
{
    m_seed = QRandomGenerator::global()->generate();
    fill();
}

void VariationsPanel::fill()
{
    if (!isVisible()) {
        return;
    }
    ++m_generation;
    m_thumbnailer.clear();
    m_back->setEnabled(!m_lineage.empty());
    int locked = 0;
    for (const Parameter& parameter : parameterTable()) {
        locked += m_locks.contains(parameter) ? 1 : 0;
    }
    m_locked->setText(locked == 0 ? tr("Lock parameters in their context menu to keep them as they are.")
                                  : tr("Locked parameters, which stay as they are: %1").arg(locked));
    for (int i = 0; i < kCells; ++i) {
        propose(i, 0);
    }
}

void VariationsPanel::propose(int cell, int attempt)
{
    Effect& effect = m_effects[static_cast<std::size_t>(cell)];
    effect = edited();
    if (cell != kMiddle) {
        // Nearer to the smoke as it is, which shows something, with each attempt.
        const float amount = std::ldexp(static_cast<float>(m_amount->value()) / 100.0F, -attempt);
        const auto seed = m_seed + static_cast<quint32>(cell + attempt * kCells);
        effect = vary(effect, amount, seed, [this](const Parameter& parameter) { return m_locks.mayVary(parameter); });
    }
    Scene scene = m_document.scene();
    scene.assign(m_document.layer(), effect);
    m_thumbnailer.request(QStringLiteral("%1/%2/%3").arg(m_generation).arg(cell).arg(attempt), scene, thumbnailEdge());
}

void VariationsPanel::receive(const QString& name, const QImage& image)
{
    const QStringList parts = name.split(QLatin1Char('/'));
    if (parts[0].toULongLong() != m_generation) {
        return;
    }
    const int cell = parts[1].toInt();
    const int attempt = parts[2].toInt();
    if (cell != kMiddle && attempt + 1 < kAttempts && !showsSomething(image)) {
        propose(cell, attempt + 1);
        return;
    }
    QPixmap pixmap = QPixmap::fromImage(image);
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    m_cells[static_cast<std::size_t>(cell)]->setIcon(pixmap);
}

void VariationsPanel::adopt(int cell)
{
    if (cell == kMiddle) {
        m_cells[kMiddle]->setChecked(true);
        return;
    }
    m_lineage.push_back(m_document.scene());
    m_seed = QRandomGenerator::global()->generate();
    m_document.replaceEffect(effectOf(cell), tr("Adopt a variation"));
}

void VariationsPanel::goBack()
{
    if (!m_lineage.empty()) {
        const Scene before = m_lineage.back();
        m_lineage.pop_back();
        m_document.replaceScene(
            before, std::min(m_document.layer(), before.layers.size() - 1), tr("Back from a variation"));
    }
}

Effect VariationsPanel::edited() const
{
    return m_document.scene().effect(m_document.layer());
}

/// While key frames are played each frame tells of a change, which is none of the smoke.
void VariationsPanel::follow()
{
    if (m_seenLayer != m_document.layer() || !(m_seen == m_document.scene())) {
        m_seen = m_document.scene();
        m_seenLayer = m_document.layer();
        m_settle.start();
    }
}

} // namespace fumage::ui
