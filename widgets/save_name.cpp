#include "save_name.h"

#include <QFileDialog>

namespace boomwatch {

QString askSaveName(QWidget* parent, const QString& title, const QString& suggestion,
                    const QString& filter, const QString& suffix) {
  QFileDialog dialog(parent, title, {}, filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);
  dialog.selectFile(suggestion);
  if (dialog.exec() != QDialog::Accepted) return {};
  return dialog.selectedFiles().value(0);
}

}  // namespace boomwatch
