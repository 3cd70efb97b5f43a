; SPDX-License-Identifier: GPL-3.0-or-later
; The setup, for one person, who need not be administrator. app/package/windows names VERSION, FILES (the folder of what is
; to be installed) and OUTPUT.
Target amd64-unicode
SetCompressor /SOLID lzma
SetCompressorDictSize 64 ; MB: the two programs are nearly the same
!include MUI2.nsh

!define CLASSES "Software\Classes"
!define OPENS "Software\Classes\Applications\slidercrank.exe"
!define UNINSTALL "Software\Microsoft\Windows\CurrentVersion\Uninstall\slidercrank"

Name "Slider-Crank"
BrandingText "Slider-Crank ${VERSION}"
OutFile "${OUTPUT}"
RequestExecutionLevel user
InstallDir "$LOCALAPPDATA\Programs\slidercrank"
InstallDirRegKey HKCU "${UNINSTALL}" InstallLocation
VIProductVersion "${VERSION}.0"
VIAddVersionKey ProductName "Slider-Crank"
VIAddVersionKey FileDescription "Slider-Crank Setup"
VIAddVersionKey FileVersion "${VERSION}"
VIAddVersionKey LegalCopyright "2026 the authors of slidercrank, GPL 3 or later"

!define MUI_ICON "${ICON}"
!define MUI_UNICON "${ICON}"
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!define MUI_FINISHPAGE_RUN "$INSTDIR\slidercrank.exe"
!insertmacro MUI_PAGE_FINISH
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE English
!insertmacro MUI_LANGUAGE Spanish

LangString program ${LANG_ENGLISH} "Slider-Crank"
LangString program ${LANG_SPANISH} "Manivela-Corredera"
LangString scene ${LANG_ENGLISH} "Slider-crank scene"
LangString scene ${LANG_SPANISH} "Escena de manivela-corredera"

; Explorer is to show the scenes' icon at once, or no more.
!macro tellOfFileTypes
    System::Call "shell32::SHChangeNotify(i 0x08000000, i 0, p 0, p 0)" ; SHCNE_ASSOCCHANGED
!macroend

Section
    SetOutPath "$INSTDIR"
    File "${FILES}/slidercrank.exe" "${FILES}/slidercrank.com" "${FILES}/LICENSE.txt" "${FILES}/NOTICES.txt"
    WriteUninstaller "$INSTDIR\uninstall.exe"
    CreateShortcut "$SMPROGRAMS\$(program).lnk" "$INSTDIR\slidercrank.exe"

    WriteRegStr HKCU "${CLASSES}\.slidercrank" "" "slidercrank.scene"
    WriteRegStr HKCU "${CLASSES}\slidercrank.scene" "" "$(scene)"
    WriteRegStr HKCU "${CLASSES}\slidercrank.scene\DefaultIcon" "" "$INSTDIR\slidercrank.exe,1"
    WriteRegStr HKCU "${CLASSES}\slidercrank.scene\shell\open\command" "" '"$INSTDIR\slidercrank.exe" "%1"'
    ; Among what tables can be opened with.
    WriteRegStr HKCU "${OPENS}" "FriendlyAppName" "$(program)"
    WriteRegStr HKCU "${OPENS}\shell\open\command" "" '"$INSTDIR\slidercrank.exe" "%1"'
    WriteRegStr HKCU "${OPENS}\SupportedTypes" ".csv" ""
    WriteRegStr HKCU "${OPENS}\SupportedTypes" ".txt" ""
    !insertmacro tellOfFileTypes

    WriteRegStr HKCU "${UNINSTALL}" DisplayName "$(program)"
    WriteRegStr HKCU "${UNINSTALL}" DisplayVersion "${VERSION}"
    WriteRegStr HKCU "${UNINSTALL}" DisplayIcon "$INSTDIR\slidercrank.exe"
    WriteRegStr HKCU "${UNINSTALL}" InstallLocation "$INSTDIR"
    WriteRegStr HKCU "${UNINSTALL}" UninstallString '"$INSTDIR\uninstall.exe"'
    WriteRegStr HKCU "${UNINSTALL}" QuietUninstallString '"$INSTDIR\uninstall.exe" /S'
    SectionGetSize 0 $0
    WriteRegDWORD HKCU "${UNINSTALL}" EstimatedSize $0
    WriteRegDWORD HKCU "${UNINSTALL}" NoModify 1
    WriteRegDWORD HKCU "${UNINSTALL}" NoRepair 1
SectionEnd

; What the setup brought; the folder only when nothing else is in it. What a person chose in the program stays.
Section Uninstall
    Delete "$INSTDIR\slidercrank.exe"
    Delete "$INSTDIR\slidercrank.com"
    Delete "$INSTDIR\LICENSE.txt"
    Delete "$INSTDIR\NOTICES.txt"
    Delete "$INSTDIR\uninstall.exe"
    RMDir "$INSTDIR"
    Delete "$SMPROGRAMS\Slider-Crank.lnk" ; by either name: the language may have changed
    Delete "$SMPROGRAMS\Manivela-Corredera.lnk"
    DeleteRegKey HKCU "${CLASSES}\.slidercrank"
    DeleteRegKey HKCU "${CLASSES}\slidercrank.scene"
    DeleteRegKey HKCU "${OPENS}"
    DeleteRegKey HKCU "${UNINSTALL}"
    !insertmacro tellOfFileTypes
SectionEnd
