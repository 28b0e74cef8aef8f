#include "ui/export/range_row.h"

#include "ui/export/number_box.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>

namespace fumage::ui {

RangeRow::RangeRow(Player& player, QWidget* parent)
    : QWidget(parent)
    , m_player(player)
    , m_frame(makeNumberBox(QStringLiteral("export.frame"), tr("Frame"), 0, kMaxFrame, this))
    , m_shown(new QLabel(this))
    , m_range(new QWidget(this))
    , m_first(makeNumberBox(QStringLiteral("export.first"), tr("First frame"), 0, kMaxFrame, m_range))
    , m_last(makeNumberBox(QStringLiteral("export.last"), tr("Last frame"), 0, kMaxFrame, m_range))
    , m_step(makeNumberBox(QStringLiteral("export.step"), tr("Step"), 1, kMaxFrame, m_range))
{
    m_shown->setObjectName(QStringLiteral("export.frame.shown"));
    m_shown->setProperty("role", QStringLiteral("secondary"));
    auto* range = new QHBoxLayout(m_range);
    range->setContentsMargins({});
    range->setSpacing(8);
    range->addWidget(m_first);
    range->addWidget(new QLabel(tr("to"), m_range));
    range->addWidget(m_last);
    range->addWidget(new QLabel(tr("every"), m_range));
    range->addWidget(m_step);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins({});
    layout->setSpacing(8);
    for (QWidget* part : std::initializer_list<QWidget*>{m_frame, m_shown, m_range}) {
        layout->addWidget(part);
    }
    layout->addStretch();
    for (QSpinBox* field : {m_frame, m_first, m_last, m_step}) {
        connect(field, &QSpinBox::valueChanged, this, &RangeRow::changed);
    }
    connect(m_frame, &QSpinBox::valueChanged, this, &RangeRow::sayWhichIsShown);
    connect(&m_player, &Player::frameChanged, this, &RangeRow::takeShown);
    connect(&m_player, &Player::playingChanged, this, &RangeRow::takeShown);
    takeShown();
    sayWhichIsShown();
}

void RangeRow::follow(ExportKind kind)
{
    const bool single = kind == ExportKind::Picture;
    m_frame->setVisible(single);
    m_shown->setVisible(single);
    m_range->setVisible(!single);
}

FrameRange RangeRow::frames(ExportKind kind) const
{
    return kind == ExportKind::Picture ? FrameRange{m_frame->value(), m_frame->value(), 1}
                                       : FrameRange{m_first->value(), m_last->value(), m_step->value()};
}

void RangeRow::setFrames(const FrameRange& frames)
{
    m_first->setValue(frames.first);
    m_last->setValue(frames.last);
    m_step->setValue(frames.step);
}

void RangeRow::takePlayed()
{
    m_first->setValue(m_player.first());
    m_last->setValue(m_player.last());
    m_frame->setValue(m_player.frame());
    sayWhichIsShown();
}

void RangeRow::takeShown()
{
    // While it plays nobody has chosen one, and a number that runs cannot be typed over.
    if (!m_player.isPlaying() || !isVisible()) {
        m_frame->setValue(m_player.frame());
    }
    sayWhichIsShown();
}

void RangeRow::sayWhichIsShown()
{
    m_shown->setText(m_frame->value() == m_player.frame() ? tr("the frame on the screen")
                                                          : tr("frame %1 is on the screen").arg(m_player.frame()));
}

} // namespace fumage::ui
