set terminal svg size 760,360 font "Helvetica,13" background rgb "white"
set output "figure.svg"
set datafile separator ","
set multiplot layout 1,2
set border 3
set tics nomirror
set bmargin 6
set key at graph 0.5, graph -0.26 center top maxcols 2 samplen 2
set xlabel "time (s)"
set ylabel "force / buoyant weight"
set yrange [0:1.2]
plot "moments.csv" skip 1 using 1:2 with lines lw 2 lc rgb "#1f5fa8" title "excess pressure", \
     "moments.csv" skip 1 using 1:3 with lines lw 2 lc rgb "#c0504d" title "floor", \
     "moments.csv" skip 1 using 1:($3+$4) with lines lw 1 lc rgb "#888888" title "together"
set ylabel "mean height / that at the start"
set yrange [0.5:1]
plot "moments.csv" skip 1 using 1:5 with lines lw 2 lc rgb "#1f5fa8" notitle
