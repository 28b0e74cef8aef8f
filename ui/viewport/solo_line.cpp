#include "ui/viewport/solo_line.h"

#include "ui/document/layer_edits.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace fumage::ui {

SoloLine::SoloLine(const Document& document, Solo& solo, QWidget* parent)
    : QFrame(parent)
    , m_document(document)
    , m_solo(solo)
    , m_label(new QLabel(this))
{
    setObjectName(QStringLiteral("soloLine"));
    setAccessibleName(tr("Solo"));
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    m_label->setObjectName(QStringLiteral("soloLine.text"));
    m_label->setTextFormat(Qt::PlainText);
    auto* end = new QToolButton(this);
    end->setObjectName(QStringLiteral("soloLine.end"));
    end->setText(tr("End solo"));
    end->setToolTip(tr("Show all layers again"));
    end->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the viewport
    auto* layout = new QHBoxLayout(this);
    constexpr int kMargin = 6;
    layout->setContentsMargins(kMargin, kMargin / 2, kMargin / 2, kMargin / 2);
    layout->addWidget(m_label);
    layout->addWidget(end);
    connect(end, &QToolButton::clicked, &solo, &Solo::end);
    connect(&solo, &Solo::changed, this, &SoloLine::follow);
    connect(&document, &Document::layersChanged, this, &SoloLine::follow);
    follow();
}

QString SoloLine::text() const
{
    return m_label->text();
}

void SoloLine::setAway(bool away)
{
    m_isAway = away;
    follow();
}

void SoloLine::follow()
{
    QStringList names;
    for (const std::size_t layer : m_solo.layers()) {
        const QString name = layerLabel(m_document.scene(), layer);
        names += m_document.scene().layers[layer].visible ? name : tr("%1 (muted)").arg(name);
    }
    constexpr int kNamed = 3; // more are counted
    m_label->setText(names.size() <= kNamed ? tr("Solo: %1").arg(names.join(QStringLiteral(", ")))
                                            : tr("Solo: %1 layers").arg(names.size()));
    setVisible(m_solo.isOn() && !m_isAway);
    adjustSize();
    raise();
}

} // namespace fumage::ui
