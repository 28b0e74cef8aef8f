#include "panel_fixture.h"

#include "core/effect/known_parameter.h"

namespace fumage::tests {

void PanelFixture::init()
{
    m_document = std::make_unique<Document>();
    m_locks = std::make_unique<Locks>();
    m_solo = std::make_unique<Solo>(*m_document);
    m_panel = std::make_unique<EffectPanel>(*m_document, *m_locks, *m_solo);
    m_panel->resize(400, 900);
    QStringList all;
    for (const Parameter& parameter : parameterTable()) {
        all += toQString(parameter.group());
    }
    m_panel->setOpenGroups(all);
    m_panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
}

void PanelFixture::cleanup()
{
    m_panel.reset();
    m_solo.reset();
    m_document.reset();
}

NumberField* PanelFixture::field(const char* name) const
{
    return childOf<NumberField>(*m_panel, QString::fromLatin1(name));
}

void PanelFixture::typeInto(NumberField& field, const QString& text)
{
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

} // namespace fumage::tests
