<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>slidercrank::AnimationForm</name>
    <message numerus="yes">
        <source>%n frames: %1 s at the playback speed of %2×.</source>
        <translation>
            <numerusform>%n frame: %1 s at the playback speed of %2×.</numerusform>
            <numerusform>%n frames: %1 s at the playback speed of %2×.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>slidercrank::CommandLine</name>
    <message numerus="yes">
        <source>%1: %2, %n rows</source>
        <translation>
            <numerusform>%1: %2, %n row</numerusform>
            <numerusform>%1: %2, %n rows</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>slidercrank::MotionFacts</name>
    <message numerus="yes">
        <source>Newton-Raphson did not converge within %n iterations: allow more iterations or a larger tolerance.</source>
        <translation>
            <numerusform>Newton-Raphson did not converge within %n iteration: allow more iterations or a larger tolerance.</numerusform>
            <numerusform>Newton-Raphson did not converge within %n iterations: allow more iterations or a larger tolerance.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>slidercrank::Report</name>
    <message numerus="yes">
        <source>%n time steps: %1</source>
        <translation>
            <numerusform>%n time step: %1</numerusform>
            <numerusform>%n time steps: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Reference: %1, %2, %n rows.</source>
        <translation>
            <numerusform>Reference: %1, %2, %n row.</numerusform>
            <numerusform>Reference: %1, %2, %n rows.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Newton-Raphson in the 12 absolute coordinates: tolerance %1 (%2), at most %n iterations per time step. Iterations: %3; largest residual: %4.</source>
        <translation>
            <numerusform>Newton-Raphson in the 12 absolute coordinates: tolerance %1 (%2), at most %n iteration per time step. Iterations: %3; largest residual: %4.</numerusform>
            <numerusform>Newton-Raphson in the 12 absolute coordinates: tolerance %1 (%2), at most %n iterations per time step. Iterations: %3; largest residual: %4.</numerusform>
        </translation>
    </message>
</context>
</TS>
