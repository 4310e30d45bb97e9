#include "parameter_dock.h"

#include <QFileDialog>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "base/error.h"
#include "parameter_editor.h"
#include "parameter_row.h"
#include "pipeline/parameter_checks.h"
#include "pipeline/preset_file.h"
#include "save_name.h"

namespace boomwatch {
namespace {

QString presetFilter() { return ParameterDock::tr("Presets (*.yaml *.yml)"); }

std::filesystem::path toPath(const QString& file) {
  return std::filesystem::path(file.toStdU16String());
}

/// A remark in the language of the window; the core's own message is English.
QString remarkText(ParameterRemark remark) {
  switch (remark) {
    case ParameterRemark::NothingEnters:
      return ParameterDock::tr(
          "No object enters the model: cells only reach p_prior / (1 - p_post), or log_odds_high. "
          "Lower the threshold.");
    case ParameterRemark::NothingLeaves:
      return ParameterDock::tr(
          "No object leaves the model: a cell stays occupied even when the camera sees through it. "
          "Raise the threshold.");
    case ParameterRemark::SearchTooShort:
      return ParameterDock::tr(
          "The search ends before the caution distance. If it finds no obstacle, there is no "
          "distance. Raise this value.");
  }
  return {};
}

}  // namespace

ParameterDock::ParameterDock(QWidget* parent) : QDockWidget(tr("Parameters"), parent) {
  setObjectName(QStringLiteral("parameters"));
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(6, 6, 0, 6);
  column->addWidget(makeHeader());
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  scroll->setWidget(makeRows());
  scroll->setMinimumWidth(scroll->widget()->minimumSizeHint().width() + 24);
  column->addWidget(scroll, 1);
  setWidget(content);
  showAll();
}

QWidget* ParameterDock::makeHeader() {
  auto* header = new QWidget;
  auto* column = new QVBoxLayout(header);
  column->setContentsMargins(0, 0, 6, 0);
  m_search = new QLineEdit;
  m_search->setPlaceholderText(tr("Search"));
  m_search->setClearButtonEnabled(true);
  m_search->setAccessibleName(tr("Search parameters"));
  connect(m_search, &QLineEdit::textChanged, this, &ParameterDock::search);
  m_message = new QLabel;
  m_message->setWordWrap(true);
  m_message->hide();

  auto* buttons = new QHBoxLayout;
  const auto add = [&](const QString& text, const QString& help, auto slot) {
    auto* button = new QPushButton(text);
    button->setToolTip(help);
    buttons->addWidget(button);
    connect(button, &QPushButton::clicked, this, slot);
  };
  add(tr("Load..."), tr("Load a preset"), &ParameterDock::askForPreset);
  add(tr("Save..."), tr("Save these values as a preset"), &ParameterDock::askWhereToSave);
  add(tr("Reset all"), tr("Reset every parameter to its default"), &ParameterDock::resetAll);
  column->addWidget(m_search);
  column->addLayout(buttons);
  column->addWidget(m_message);
  return header;
}

QWidget* ParameterDock::makeRows() {
  auto* rows = new QWidget;
  auto* column = new QVBoxLayout(rows);
  column->setContentsMargins(0, 0, 6, 0);
  for (const ParameterInfo& info : parameterTable()) {
    addRow(groupOf(info.group, column), new ParameterRow(info));
  }
  column->addStretch(1);
  return rows;
}

ParameterDock::Group& ParameterDock::groupOf(const char* name, QVBoxLayout* column) {
  const QString title = parameterText(name);
  const auto found = std::find_if(m_groups.begin(), m_groups.end(),
                                  [&](const Group& group) { return group.box->title() == title; });
  if (found != m_groups.end()) return *found;
  auto* box = new QGroupBox(title);
  auto* inside = new QVBoxLayout(box);
  inside->setSpacing(4);
  column->addWidget(box);
  return m_groups.emplace_back(Group{box, {}});
}

void ParameterDock::addRow(Group& group, ParameterRow* row) {
  group.box->layout()->addWidget(row);
  group.rows.push_back(row);
  connect(row, &ParameterRow::edited, this, [this, row] {
    row->write(m_parameters);
    apply();
  });
  connect(row, &ParameterRow::resetRequested, this, [this, row] {
    row->info().set(m_parameters, row->info().get(Parameters{}));
    row->showValue(m_parameters);
    apply();
  });
}

void ParameterDock::setParameters(const Parameters& parameters) {
  m_parameters = parameters;
  showAll();
}

void ParameterDock::changeParameters(const Parameters& parameters) {
  setParameters(parameters);
  apply();
}

void ParameterDock::showAll() {
  for (const Group& group : m_groups) {
    for (ParameterRow* row : group.rows) row->showValue(m_parameters);
  }
  check();
}

void ParameterDock::apply() {
  if (check()) emit parametersChanged(m_parameters);
}

bool ParameterDock::check() {
  for (const Group& group : m_groups) {
    for (ParameterRow* row : group.rows) row->setMessage({});
  }
  setMessage({});
  for (const ParameterWarning& warning : warningsFor(m_parameters)) {
    if (ParameterRow* named = row(warning.key)) named->setMessage(remarkText(warning.remark));
  }
  try {
    validate(m_parameters);
    return true;
  } catch (const Error& error) {
    const QString text = QString::fromStdString(error.what());
    setMessage(tr("Not applied until these agree: %1").arg(text));
    for (const Group& group : m_groups) {
      for (ParameterRow* row : group.rows) {
        const std::string quoted = "'" + std::string(row->info().key) + "'";
        if (text.contains(QString::fromStdString(quoted))) row->setMessage(tr("Not applied"));
      }
    }
    return false;
  }
}

void ParameterDock::setMessage(const QString& text) {
  m_message->setText(text.isEmpty() ? QString() : QStringLiteral("\u26A0 ") + text);
  m_message->setVisible(!text.isEmpty());
}

QString ParameterDock::message() const { return m_message->text(); }

ParameterRow* ParameterDock::row(std::string_view key) const {
  for (const Group& group : m_groups) {
    for (ParameterRow* row : group.rows) {
      if (row->info().key == key) return row;
    }
  }
  return nullptr;
}

void ParameterDock::resetAll() { changeParameters({}); }

void ParameterDock::search(const QString& text) {
  for (const Group& group : m_groups) {
    bool any = false;
    for (ParameterRow* row : group.rows) {
      const bool found = row->matches(text.trimmed());
      row->setVisible(found);
      any = any || found;
    }
    group.box->setVisible(any);
  }
}

void ParameterDock::askForPreset() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Load a preset"), {}, presetFilter());
  if (!file.isEmpty()) loadPresetFile(file);
}

void ParameterDock::askWhereToSave() {
  const QString suffix = QStringLiteral("yaml");
  const QString file = askSaveName(this, tr("Save these values as a preset"),
                                   QStringLiteral("boomwatch.") + suffix, presetFilter(), suffix);
  if (!file.isEmpty()) savePresetFile(file);
}

bool ParameterDock::loadPresetFile(const QString& file) {
  try {
    const Parameters loaded = loadPreset(toPath(file));
    changeParameters(loaded);
    return true;
  } catch (const std::exception& error) {
    setMessage(QString::fromStdString(error.what()));
    return false;
  }
}

bool ParameterDock::savePresetFile(const QString& file) {
  try {
    savePreset(toPath(file), m_parameters);
    return true;
  } catch (const std::exception& error) {
    setMessage(QString::fromStdString(error.what()));
    return false;
  }
}

}  // namespace boomwatch
