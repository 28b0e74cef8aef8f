#include "ui/noise_preview/noise_pane.h"

#include "ui/document/text.h"
#include "ui/document/number_text.h"
#include "ui/theme/icons.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kAnimationMs = 40;
constexpr int kSlices = 256; ///< positions of the slider

} // namespace

NoisePane::NoisePane(Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_canvas(new NoiseCanvas(this))
    , m_plots(new NoisePlots(this))
    , m_channel(new QComboBox(this))
    , m_slice(new QSlider(Qt::Horizontal, this))
    , m_facts(new QLabel(this))
{
    setObjectName(QStringLiteral("noisePane"));
    build();
    connectParts();
}

void NoisePane::build()
{
    m_channel->setObjectName(QStringLiteral("noiseChannel"));
    m_channel->setAccessibleName(tr("Channel"));
    m_channel->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_channel->setMinimumContentsLength(3);
    m_channel->addItems({tr("Texture"), tr("Sum of octaves"), tr("Alpha of a particle")});
    m_channel->setToolTip(tr("What is shown: the grey values that particles read, the noise before sharpness, or what "
                             "is left under the mask of a particle"));
    m_slice->setObjectName(QStringLiteral("noiseSlice"));
    m_slice->setAccessibleName(tr("Slice"));
    m_slice->setToolTip(tr("Which slice of the 3D noise; particles go through them as they age"));
    m_slice->setRange(0, kSlices - 1);
    m_facts->setObjectName(QStringLiteral("noiseFacts"));
    m_facts->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_facts->setProperty("role", QStringLiteral("secondary"));

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addLayout(makeBar());
    layout->addWidget(m_canvas, 1);
    layout->addWidget(m_slice);
    layout->addWidget(m_plots);
    layout->addWidget(m_facts);
}

void NoisePane::addControls(QWidget* controls)
{
    auto* box = static_cast<QVBoxLayout*>(layout());
    box->insertWidget(box->indexOf(m_plots), controls);
}

QHBoxLayout* NoisePane::makeBar()
{
    auto* bar = new QHBoxLayout;
    bar->setSpacing(2);
    bar->addWidget(m_channel, 1);
    m_plain = addToggle(QStringLiteral("noisePlain"), QStringLiteral("compare"), tr("Without smoothing and sharpness"));
    m_tiled = addToggle(
        QStringLiteral("noiseTiled"), QStringLiteral("tiles"), tr("Three by three tiles, to judge the seams"));
    m_profile = addToggle(QStringLiteral("noiseProfile"), QStringLiteral("profile"),
        tr("Profile along a line, with amplitude and wavelength"));
    m_profile->setChecked(true);
    m_animate = addToggle(QStringLiteral("noiseAnimate"), QStringLiteral("play"), tr("Go through the slices"));
    QToolButton* save =
        makeIconButton(this, QStringLiteral("noiseExport"), QStringLiteral("export"), tr("Export the noise texture…"));
    save->setAccessibleName(tr("Export the noise texture"));
    for (QToolButton* button : {m_plain, m_tiled, m_profile, m_animate, save}) {
        bar->addWidget(button);
    }
    connect(save, &QToolButton::clicked, this, &NoisePane::exportRequested);
    return bar;
}

void NoisePane::connectParts()
{
    m_clock.setInterval(kAnimationMs);
    connect(&m_clock, &QTimer::timeout, this, &NoisePane::advance);
    connect(&m_worker, &NoiseWorker::ready, this, &NoisePane::receive);
    connect(&m_worker, &NoiseWorker::exhausted, this,
        [this] { m_facts->setText(tr("There is not enough memory for this texture.")); });
    connect(&m_worker, &NoiseWorker::failed, this, [this](const Error& why) { m_facts->setText(translated(why)); });
    connect(&m_document, &Document::effectChanged, this, &NoisePane::refresh);
    connect(m_channel, &QComboBox::currentIndexChanged, this, &NoisePane::refresh);
    connect(m_plain, &QToolButton::toggled, this, &NoisePane::refresh);
    connect(m_slice, &QSlider::valueChanged, this, &NoisePane::refresh);
    connect(m_tiled, &QToolButton::toggled, m_canvas, &NoiseCanvas::setTiled);
    connect(m_profile, &QToolButton::toggled, m_canvas, &NoiseCanvas::setLineShown);
    connect(m_profile, &QToolButton::toggled, m_plots, &NoisePlots::setProfileShown);
    connect(m_animate, &QToolButton::toggled, this, [this](bool on) { on ? m_clock.start() : m_clock.stop(); });
    connect(m_canvas, &NoiseCanvas::lineMoved, this, &NoisePane::plot);
}

void NoisePane::plot()
{
    m_plots->show(m_picture, m_canvas->line(), static_cast<double>(m_document.effect().noise.wavelength));
}

QToolButton* NoisePane::addToggle(const QString& name, const QString& icon, const QString& tip)
{
    QToolButton* button = makeIconButton(this, name, icon, tip);
    button->setCheckable(true);
    return button;
}

void NoisePane::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (m_stale) {
        refresh();
    }
    if (m_animate->isChecked()) {
        m_clock.start();
    }
}

void NoisePane::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_clock.stop();
}

void NoisePane::advance()
{
    // Only when the last slice is there: a slow machine goes slower.
    if (m_picture && m_picture->serial == m_serial) {
        m_slice->setValue((m_slice->value() + 1) % kSlices);
    }
}

void NoisePane::refresh()
{
    m_stale = !isVisible();
    if (m_stale) {
        return;
    }
    const Effect& effect = m_document.effect();
    NoiseRequest request;
    request.noise = effect.noise;
    request.look = effect.look;
    request.depth = static_cast<float>(m_slice->value()) / kSlices;
    request.size = std::min(effect.noise.resolution, kMaxTextureSize);
    request.channel = static_cast<NoiseChannel>(m_channel->currentIndex());
    request.plain = m_plain->isChecked();
    if (m_asked && request.asksAs(*m_asked)) {
        return;
    }
    request.serial = ++m_serial;
    m_asked = request;
    m_worker.request(request);
}

void NoisePane::receive(const NoisePicturePtr& picture)
{
    m_picture = picture;
    m_canvas->show(picture);
    plot();
    m_facts->setText(tr("%1 × %1 px   mean %2   deviation %3")
                         .arg(picture->tile.size)
                         .arg(formatFixed(picture->mean, 2), formatFixed(picture->deviation, 2)));
    emit pictureShown();
}

} // namespace fumage::ui
